// Curvature of segmented images: bodies as binary masks, whose surfaces are staircases.

#include "apps/validate/Cases.h"

#include "solver/surface/FittedCurvature.h"
#include "vtkfilters/Filters/MeshConversion.h"

#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace vesicle::validation
{
namespace
{

struct Curvatures
{
  double mean, gauss;
};

/// In voxels, about the origin.
struct SegmentedBody
{
  double radius;    ///< of curvature, in which errors are counted
  double half_size; ///< of the image
  std::function<bool(const Vector3&)> inside;
  std::function<Curvatures(const Vector3&)> exact; ///< at the surface's point nearest to x
  std::function<bool(const Vector3&)> counts = [](const Vector3&) { return true; };
};

/// Seen along axes that aren't the voxels'.
Vector3 turned(const Vector3& x)
{
  static const Eigen::Matrix3d rotation =
    Eigen::AngleAxisd(0.7, Vector3(1, 2, 0.5).normalized()).toRotationMatrix();
  return rotation * x;
}

SegmentedBody ball(double R)
{
  return { R, R + 3, [R](const Vector3& x) { return x.norm() < R; },
    [R](const Vector3&) {
      return Curvatures{ 1 / R, 1 / (R * R) };
    } };
}

/// Open where the image ends: only its middle counts.
SegmentedBody cylinder(double R)
{
  return { R, 2 * R, [R](const Vector3& x) { return turned(x).head<2>().norm() < R; },
    [R](const Vector3&) {
      return Curvatures{ 0.5 / R, 0 };
    },
    [R](const Vector3& x) { return std::abs(turned(x).z()) < R / 2; } };
}

/// Of tube radius R around a circle of radius 2R.
SegmentedBody torus(double R)
{
  const auto from_circle = [R](const Vector3& x)
  {
    const Vector3 y = turned(x);
    return Eigen::Vector2d(y.head<2>().norm() - 2 * R, y.z());
  };
  return { R, 3 * R + 3, [=](const Vector3& x) { return from_circle(x).norm() < R; },
    [=](const Vector3& x)
    {
      const double outward = from_circle(x).normalized().x();
      const double around = outward / (2 * R + R * outward);
      return Curvatures{ (1 / R + around) / 2, around / R };
    } };
}

/// z = (x² − y²)/2R, the body below it; only its middle counts.
SegmentedBody saddle(double R)
{
  const auto height = [R](const Vector3& x) { return (x.x() * x.x() - x.y() * x.y()) / (2 * R); };
  return { R, R, [=](const Vector3& x) { return turned(x).z() < height(turned(x)); },
    [=](const Vector3& at)
    {
      // The height at the point itself is good enough for its slopes: half a voxel away.
      const Vector3 x = turned(at);
      const double zx = x.x() / R, zy = -x.y() / R, g = 1 + zx * zx + zy * zy;
      return Curvatures{ (zx * zx - zy * zy) / (2 * R * std::pow(g, 1.5)), -1 / (R * R * g * g) };
    },
    [R](const Vector3& x) { return turned(x).head<2>().norm() < 0.4 * R; } };
}

/// The mask's isosurface, its vertices half-way between voxels inside and outside; it faces
/// outward.
TriangleMesh isosurface_of(const SegmentedBody& body)
{
  const Vector3 origin(0.13, -0.27, 0.41); // of the body among the voxels: no symmetry
  const int half = static_cast<int>(std::ceil(body.half_size)), size = 2 * half + 1;
  vtkNew<vtkImageData> image;
  image->SetDimensions(size, size, size);
  image->SetOrigin(-half - origin.x(), -half - origin.y(), -half - origin.z());
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* mask = static_cast<unsigned char*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    Vector3 x;
    image->GetPoint(i, x.data());
    mask[i] = body.inside(x);
  }
  vtkNew<vtkFlyingEdges3D> isosurface;
  isosurface->SetInputData(image);
  isosurface->SetValue(0, 0.5);
  isosurface->Update();
  TriangleMesh mesh = to_mesh(isosurface->GetOutput());
  const auto [a, b, c] = corners(mesh, 0);
  if (body.inside((a + b + c) / 3 + (b - a).cross(c - a).normalized()))
  {
    mesh.triangles.col(1).swap(mesh.triangles.col(2));
  }
  return mesh;
}

/// Mean and standard deviation.
class Moments
{
public:
  void add(double error)
  {
    ++count_;
    sum_ += error;
    squares_ += error * error;
  }
  double bias() const { return sum_ / count_; }
  double deviation() const { return std::sqrt(squares_ / count_ - bias() * bias()); }

private:
  int count_ = 0;
  double sum_ = 0, squares_ = 0;
};

/// A radius and what bias and deviation may be, of H and of K, in units of the body's radius.
struct RadiusLimits
{
  double radius;
  double mean_bias, mean_deviation, gauss_bias, gauss_deviation;
};

void add_radius(
  Report& report, const SegmentedBody& body, const TriangleMesh& mesh, const RadiusLimits& limits)
{
  const Connectivity connectivity(mesh.triangles, static_cast<int>(mesh.points.rows()));
  const FittedCurvature fit = fitted_curvature(mesh, connectivity, { limits.radius, false });
  Moments mean, gauss;
  const double R = body.radius;
  for (int i = 0; i < mesh.points.rows(); ++i)
  {
    const Vector3 x = mesh.points.row(i);
    if (fit.border[i] || !body.counts(x))
    {
      continue;
    }
    const Curvatures exact = body.exact(x);
    mean.add(R * (fit.curvature.mean[i] - exact.mean));
    gauss.add(R * R * (fit.curvature.gauss[i] - exact.gauss));
  }
  const std::string radius =
    limits.radius > 0 ? fmt::format("radius {}", limits.radius) : std::string("nearest");
  report.add(absolute(radius + ": H R, bias", 0, mean.bias(), limits.mean_bias));
  report.add(at_most(radius + ": H R, deviation", limits.mean_deviation, mean.deviation()));
  report.add(absolute(radius + ": K R2, bias", 0, gauss.bias(), limits.gauss_bias));
  report.add(at_most(radius + ": K R2, deviation", limits.gauss_deviation, gauss.deviation()));
}

/// The fast set has one radius alone.
Case segmented_case(const std::string& name, const std::string& about, const SegmentedBody& body,
  double fast_radius, const std::vector<RadiusLimits>& radii)
{
  return { "segmented/" + name,
    about + " as a binary mask: bias and deviation of curvatures fitted within a radius, in voxels",
    Case::Set::fast,
    [=](Report& report)
    {
      const TriangleMesh mesh = isosurface_of(body);
      for (const RadiusLimits& limits : radii)
      {
        if (report.full() || limits.radius == fast_radius)
        {
          add_radius(report, body, mesh, limits);
        }
      }
    } };
}

}

std::vector<Case> segmented_cases()
{
  // Measured, with a quarter to spare. The first is what the nearest vertices tell.
  const std::vector<RadiusLimits> of_ball{ { 0, 0.08, 37, 410, 1630 },
    { 6, 0.015, 0.31, 0.031, 0.72 }, { 9, 7e-3, 0.092, 0.014, 0.19 },
    { 12, 4.1e-3, 0.038, 8.2e-3, 0.076 }, { 18, 1.9e-3, 0.011, 3.9e-3, 0.022 },
    { 24, 1.1e-3, 4.6e-3, 2.2e-3, 9.1e-3 }, { 36, 6.5e-4, 1.3e-3, 1.3e-3, 2.6e-3 } };
  const std::vector<RadiusLimits> of_small_ball{ { 4, 0.03, 0.2, 0.059, 0.41 },
    { 6, 0.016, 0.054, 0.032, 0.11 }, { 8, 0.01, 0.022, 0.02, 0.043 } };
  const std::vector<RadiusLimits> of_cylinder{ { 6, 6.5e-3, 0.12, 1e-3, 0.16 },
    { 8, 4.5e-3, 0.044, 1e-3, 0.06 }, { 12, 2.5e-3, 0.0125, 1.2e-3, 0.016 },
    { 16, 1.5e-3, 4.7e-3, 7.5e-4, 6.4e-3 } };
  const std::vector<RadiusLimits> of_torus{ { 6, 7e-3, 0.12, 1e-3, 0.16 },
    { 8, 3.9e-3, 0.054, 1.6e-3, 0.07 }, { 12, 2e-3, 0.017, 3.7e-3, 0.025 },
    { 16, 1.9e-3, 0.012, 6.7e-3, 0.02 } };
  const std::vector<RadiusLimits> of_saddle{ { 6, 1.5e-3, 0.12, 0.043, 0.16 },
    { 8, 2.6e-3, 0.042, 0.044, 0.058 }, { 12, 1.5e-3, 0.017, 0.07, 0.025 } };
  return {
    segmented_case("ball", "A ball of radius 60", ball(60), 12, of_ball),
    segmented_case("small-ball", "A ball of radius 12", ball(12), 6, of_small_ball),
    segmented_case("cylinder", "A cylinder of radius 25", cylinder(25), 12, of_cylinder),
    segmented_case("torus", "A torus of tube radius 25, circle 50", torus(25), 12, of_torus),
    segmented_case("saddle", "The saddle z = (x2 - y2)/50", saddle(25), 12, of_saddle),
  };
}

}
