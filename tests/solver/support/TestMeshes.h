#pragma once
// Meshes for tests: regular and irregular, spherical and not.

#include "solver/mesh/Shapes.h"
#include "solver/mesh/TriangleMesh.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace vesicle::test
{

using Map = std::function<Vector3(const Vector3&)>;

/// Every point moved by `map`.
TriangleMesh mapped(TriangleMesh mesh, const Map& map);

/// A unit sphere with about that many triangles, smooth enough for Loop's surface.
TriangleMesh smooth_sphere(int triangles);

/// A geodesic sphere with its points shifted along the sphere by up to `fraction` of the mean edge,
/// by a fixed pseudo-random sequence: triangles of all sizes and angles.
TriangleMesh jittered_sphere(int n, double fraction);

/// (2 n_x, n_y, n_z), the ellipsoid of data/reference.
Vector3 ellipsoid_2_1_1(const Vector3& direction);
/// r = 1 + 0.2 Y20.
Vector3 perturbed_sphere(const Vector3& direction);
/// r = 1 + 0.61 n_x + 0.4 n_x² n_y, the smooth variant of the paper's 4.1.
Vector3 paper_surface(const Vector3& direction);

/// The Clifford torus, R = √2, r = 1, by a grid of 2 · around · across triangles.
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
