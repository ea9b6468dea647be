#pragma once
// The triangulations that the mesh of a surface can have.

#include "solver/mesh/shapes/SphereMesh.h"

#include <vector>

namespace vesicle
{

/// The capped tubes and geodesic spheres with about that number of triangles, around the surface's
/// axis, or around each that it may be long or flat along, with what symmetries they share with it.
/// They have the number asked for if it is a multiple of 10 or 12, otherwise the nearest; with
/// Symmetry::half_turns a multiple of 12 or 20 n².
std::vector<SphereMesh> placed_triangulations(int triangles, Symmetry symmetry);

/// On the score of a mesh that has not quite the number of triangles asked for: a factor.
double count_merit(Eigen::Index has, int asked_for);

/// Rounds of smoothing: to see which triangulation suits a surface, until a mesh has settled, and
/// after each time that it was cut finer.
inline constexpr int trial_passes = 40, settling_passes = 200, fine_passes = 60;

/// Fine meshes are cut from coarse ones, on which many triangulations can be tried and long-wave
/// unevenness is smoothed: with how many triangles to begin, and how often each is cut in four.
struct CoarseCount
{
  int triangles;
  int refinements;
};
CoarseCount coarse_count(int triangles);

}
