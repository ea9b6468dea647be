#pragma once
// A run that lies in a folder, found by what it left there.

#include "apps/RunBeside.h"
#include "apps/RunFolder.h"

#include "vtkfilters/Filters/SeriesFile.h"

#include <string>
#include <vector>

namespace vesicle
{

struct FoundRun
{
  RunFolder folder;
  std::string name;
  std::vector<SeriesFrame> frames; ///< none where the run has no series yet
  RunBeside beside;
};

/// The one run in a folder. Throws InputError where there is none or are several, or what it left
/// can't be understood.
FoundRun run_in(const std::filesystem::path& folder);

}
