#include "solver/mesh/shapes/SampleMeshes.h"

#include "solver/mesh/HalfEdgeMesh.h"
#include "solver/mesh/shapes/GeodesicSphere.h"
#include "solver/mesh/shapes/Shapes.h"
#include "solver/mesh/shapes/SphericalHarmonics.h"

#include <cmath>
#include <numbers>
#include <random>

namespace vesicle
{

TriangleMesh smooth_sphere(int triangles)
{
  ShapeRequest request;
  request.triangles = triangles;
  TriangleMesh mesh = make_shape(request);
  mesh.points.rowwise().normalize();
  return mesh;
}

TriangleMesh jittered_sphere(int n, double fraction)
{
  TriangleMesh mesh = geodesic_sphere(n);
  const double edge = std::sqrt(4 * std::numbers::pi / mesh.triangles.rows() * 4 / std::sqrt(3.));
  std::mt19937 random(20260101);
  std::uniform_real_distribution<double> shift(-fraction * edge, fraction * edge);
  return mapped(mesh,
    [&](const Vector3& x) -> Vector3
    {
      const double a = shift(random), b = shift(random);
      const Vector3 u = x.unitOrthogonal();
      return (x + a * u + b * x.cross(u)).normalized();
    });
}

TriangleMesh delaunay_sphere(const TriangleMesh& sphere)
{
  HalfEdgeMesh mesh(sphere.triangles, static_cast<int>(sphere.points.rows()));
  const auto point = [&](int i) -> Vector3 { return sphere.points.row(i); };
  bool flipped = true;
  for (int round = 0; flipped && round < 50; ++round)
  {
    flipped = false;
    for (int h = 0; h < mesh.half_edges(); ++h)
    {
      const Vector3 a = point(mesh.from(h));
      const int c = mesh.apex(h), d = mesh.apex(mesh.twin(h));
      const double above =
        (point(mesh.to(h)) - a).cross(point(c) - a).dot(point(d) - a); // the other apex, the face
      if (above > 1e-12 && mesh.find(c, d) < 0)
      {
        mesh.flip(h);
        flipped = true;
      }
    }
  }
  return { sphere.points, mesh.triangles() };
}

Vector3 ellipsoid_2_1_1(const Vector3& d)
{
  return { 2 * d.x(), d.y(), d.z() };
}

Vector3 perturbed_sphere(const Vector3& d)
{
  return (1 + 0.2 * real_spherical_harmonic(2, 0, d)) * d;
}

Vector3 paper_surface(const Vector3& d)
{
  return (1 + 0.61 * d.x() + 0.4 * d.x() * d.x() * d.y()) * d;
}

Vector3 printed_paper_surface(const Vector3& d)
{
  const double across = d.x() * d.x() + d.y() * d.y();
  const double last = across > 0 ? d.x() * d.x() * d.y() / across : 0;
  return (1 + 0.61 * d.x() + 0.4 * last) * d;
}

}
