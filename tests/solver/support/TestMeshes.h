#pragma once
// Meshes for tests: regular and irregular, spherical and not.

#include "solver/mesh/shapes/SampleMeshes.h"

#include <map>
#include <string>
#include <vector>

namespace vesicle::test
{

using Map = SphericalParametrisation;
using vesicle::ellipsoid_2_1_1;
using vesicle::jittered_sphere;
using vesicle::mapped;
using vesicle::paper_surface;
using vesicle::perturbed_sphere;
using vesicle::smooth_sphere;

/// A prolate of reduced volume .95 with 80 triangles, as runs start from.
TriangleMesh small_prolate();

/// A torus about z of radii R and r by a grid of 2 · around · across triangles.
TriangleMesh torus(double R, double r, int around, int across);
/// The Clifford torus: R = √2, r = 1.
TriangleMesh clifford_torus(int around, int across);

/// Points and triangles in another order: new point i is old point order[i].
struct Renumbered
{
  TriangleMesh mesh;
  std::vector<int> order;
};
Renumbered renumbered(const TriangleMesh& mesh);

/// Columns of a CSV file of data/reference, by name; lines starting with # are skipped.
std::map<std::string, std::vector<double>> read_reference(const std::string& file);

/// y at x by linear interpolation between (xs, ys) in any order.
double interpolate(const std::vector<double>& xs, const std::vector<double>& ys, double x);

/// log2 of the ratio of two errors, of meshes whose edge lengths have the ratio 2: the order in h.
double order(double coarse_error, double fine_error);

}
