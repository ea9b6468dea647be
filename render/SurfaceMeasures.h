#pragma once
// What a picture needs to know of a triangulated surface.

#include "solver/mesh/TriangleMesh.h"

#include <array>
#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace vesicle
{

using Point3 = std::array<double, 3>;

inline Vector3 vector_of(const Point3& p)
{
  return { p[0], p[1], p[2] };
}

/// Centroid of the enclosed volume; of the area where the surface is open or encloses nothing.
/// Throws InputError when there is no triangle or a point is not finite.
Point3 surface_centroid(vtkPolyData* surface);

/// The enclosed volume; 0 where the surface is open or encloses nothing.
double enclosed_volume(vtkPolyData* surface);

/// Whether the surface's inner side can't be seen from outside: it is closed, all of its pieces face
/// outward and it doesn't pass through itself.
bool hides_its_inside(vtkPolyData* surface);

/// Velocity of the enclosed volume's centroid from the points' velocities (3 components):
/// (1/V) ∮ (x − x_c) (u·n) dA; the area's mean velocity where nothing is enclosed.
Point3 centroid_velocity(vtkPolyData* surface, vtkDataArray* velocity);

/// Unit normals: the point array Normals where there is one, otherwise those of the triangles
/// around each point, weighted by area; 0 where there is none.
std::vector<Point3> point_normals(vtkPolyData* surface);

/// The point array of that name. Throws InputError, listing the arrays that there are, when it is
/// missing, has neither 1 nor 3 components, or holds a value that is not finite.
vtkDataArray* finite_point_array(vtkPolyData* surface, const std::string& name);

/// The same of three components; `what`: is drawn of it, for the error where it has another number.
vtkDataArray* finite_vectors(
  vtkPolyData* surface, const std::string& name, const std::string& what);

/// So many of the surface's points, or all: each next one is the farthest from those before.
std::vector<long long> spread_points(vtkPolyData* surface, int count);

/// A component's value, or the magnitude of a vector.
double scalar_value(vtkDataArray* array, long long point);

}
