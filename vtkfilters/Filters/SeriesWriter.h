#pragma once
// Writing a time series of surfaces, frame by frame.

#include "VesicleFiltersModule.h"

#include "SeriesFile.h"

#include "solver/state/XdmfFile.h"

class vtkDataObject;
class vtkPolyData;

namespace vesicle
{

/// DIR/frames/NAME_000000.vtu, …, listed in DIR/NAME.pvd and DIR/NAME.vtu.series, and the same
/// frames as DIR/frames/NAME_000000.h5, …, listed in DIR/NAME.xdmf. What is on the disk is a valid
/// series after every frame, also if the program is killed in between: a frame's file is there as a
/// whole before it is listed. Frames are unstructured grids of triangles in double precision:
/// inline binary data, zlib, 64-bit headers, numeric field data; or HDF5 (FrameFile.h). All
/// functions throw IoError naming the file that can't be written.
class VESICLEFILTERS_EXPORT SeriesWriter
{
public:
  SeriesWriter(std::filesystem::path folder, std::string name);

  /// Throws InputError naming the file that is missing unless the first `count` frames are there.
  void require_frames(std::size_t count) const;
  /// Goes on with the series in the folder after the frames of these times, its first; later ones
  /// are removed. All have the triangles and arrays of `like`. Throws InputError as well, as above.
  void keep(const std::vector<double>& times, vtkPolyData* like);

  /// Adds a frame, of what triangulated() takes; a field data array TimeValue of one value holds the time as well.
  void append(vtkDataObject* surface, double time);

  const std::vector<SeriesFrame>& frames() const { return frames_; }
  /// The frames' files from here.
  std::vector<std::filesystem::path> files() const;
  std::filesystem::path pvd_file() const;
  std::filesystem::path series_file() const;
  std::filesystem::path xdmf_file() const;

private:
  std::filesystem::path frame_name(std::size_t index, const char* ending) const;
  void list(double time, FrameLayout layout);
  void list_frames() const;
  void remove_frames_from(std::size_t index) const;

  std::filesystem::path folder_;
  std::string name_;
  std::vector<SeriesFrame> frames_;
  std::vector<XdmfFrame> xdmf_frames_; ///< the same
};

}
