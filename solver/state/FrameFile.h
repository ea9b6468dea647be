#pragma once
// One frame of a run as an HDF5 file, for programs that read the run's .xdmf:
//   /points              double  #points × 3
//   /triangles           int32   #triangles × 3
//   /point_data/<array>  double  #points, or #points × components
//   /cell_data/<array>   double  #triangles, or #triangles × components
//   /field_data/<array>  double  numbers of the frame as a whole
//   attributes of /      format, time
// Datasets are compressed (shuffle, deflate), in one chunk each.

#include "solver/mesh/TriangleMesh.h"

#include <filesystem>
#include <string>
#include <vector>

namespace vesicle
{

struct FrameArray
{
  using Values = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  std::string name; ///< without '/' and ':'
  Values values;    ///< one row a point, triangle or entry
};

struct Frame
{
  double time = 0;
  TriangleMesh mesh;
  std::vector<FrameArray> point_data, cell_data, field_data;
};

/// What an .xdmf file says of a frame; arrays in alphabetical order.
struct FrameLayout
{
  struct Array
  {
    std::string name;
    long components = 1;
  };
  long points = 0, triangles = 0;
  std::vector<Array> point_data, cell_data;
};

FrameLayout layout_of(const Frame& frame);
/// Of a frame's file. Throws IoError naming the file.
FrameLayout read_frame_layout(const std::filesystem::path& file);

/// The bytes of a frame's file; equal frames have equal ones. Throws IoError.
std::string frame_file_image(const Frame& frame);

}
