#pragma once
// Time series that other programs open: a .pvd or .vtu.series file that lists the frames' files.

#include "VesicleFiltersModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace vesicle
{

struct SeriesFrame
{
  double time = 0;
  std::filesystem::path file; ///< from the folder of the series when written, from here when read
};

VESICLEFILTERS_EXPORT bool is_series(const std::filesystem::path& file); ///< by its ending
/// Reads a .pvd or .series file. Throws InputError naming the file and what is wrong.
VESICLEFILTERS_EXPORT std::vector<SeriesFrame> read_series(const std::filesystem::path& file);

VESICLEFILTERS_EXPORT std::string pvd_text(const std::vector<SeriesFrame>& frames);
VESICLEFILTERS_EXPORT std::string series_text(const std::vector<SeriesFrame>& frames);

}
