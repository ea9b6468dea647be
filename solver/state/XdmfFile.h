#pragma once
// The .xdmf file that shows the frames of a run, which are HDF5 files, as one time series.

#include "solver/state/FrameFile.h"

#include <filesystem>
#include <string>
#include <vector>

namespace vesicle
{

struct XdmfFrame
{
  double time = 0;
  std::filesystem::path file; ///< HDF5 (FrameFile.h), from the folder of the .xdmf file
  FrameLayout layout;
};

/// XDMF 3: a temporal collection, a grid of triangles a frame. The points are there as an array
/// Position as well: of moving points some readers give those of the first frame only.
std::string xdmf_text(const std::string& name, const std::vector<XdmfFrame>& frames);

}
