#pragma once
// A mesh as a segmentation or a scan gives it, made one that dynamics can start from.

#include "solver/mesh/TriangleMesh.h"

#include <optional>
#include <string>
#include <vector>

namespace vesicle
{

struct RepairSettings
{
  std::optional<double> merge;  ///< distance, > 0; empty: what closes a seam (seam_gap), else 1e-9
                                ///< of the mesh's diagonal
  double scrap_share = 0.01;    ///< components with less of the largest one's area are dropped
  int scrap_triangles = 0;      ///< and those with fewer triangles
  bool largest_only = false;    ///< all but the one with the largest area
  double largest_hole = 0.5;    ///< Hole::size of those that are filled
  int smoothing_passes = 0;     ///< smooth_noise()
  std::optional<int> triangles; ///< of each body, resampled by remesh(); empty: as they are
};

struct MeshFigures
{
  Eigen::Index points = 0, triangles = 0;
  int components = 0;
  double area = 0;
  std::optional<double> volume; ///< of a closed, oriented mesh
};

struct RepairReport
{
  MeshFigures before, after;
  double merge_distance = 0;
  int merged_points = 0, unused_points = 0;
  int triangles_without_area = 0, doubled_triangles = 0;
  int parted_points = 0;
  int scraps = 0, scrap_triangles = 0;
  double scrap_area = 0; ///< over the area of all
  int turned_triangles = 0;
  int filled_holes = 0;
  int open_holes = 0; ///< that are left, as they are larger
  int smoothing_passes = 0;
  std::vector<std::string> resampled; ///< of each body, in words

  bool changed_anything() const;
};

struct Repaired
{
  TriangleMesh mesh; ///< the same to the bit where nothing was changed
  RepairReport report;
};

/// In this order: points merged, triangles without area or twice there dropped, sheets parted,
/// scraps dropped, triangles turned to agree, holes filled, bodies turned outward (the inner side
/// of a shell inward), noise smoothed, bodies resampled. Throws InputError "name: …" where the mesh
/// is empty, a surface has one side only, nothing is left, or a body can't be resampled.
Repaired repair(TriangleMesh mesh, const RepairSettings& settings, const std::string& name);

/// A line for each thing that was done, and the figures before and after.
std::string to_text(const RepairReport& report);

}
