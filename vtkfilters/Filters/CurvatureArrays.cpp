#include "CurvatureArrays.h"

#include "MeshConversion.h"

#include "solver/membrane/HelfrichBending.h"
#include "solver/mesh/Connectivity.h"
#include "solver/surface/Cotan.h"
#include "solver/surface/FitRadius.h"
#include "solver/surface/FittedCurvature.h"
#include "solver/surface/LoopCurvature.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVesicleCurvatureFilter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace vesicle
{
namespace
{

using Mask = std::vector<bool>;

/// Where the curvature is defined: triangles all around the vertex.
Mask inner_vertices(const Connectivity& connectivity)
{
  const std::vector<char> border = border_vertices(connectivity);
  Mask inner(border.size());
  for (std::size_t i = 0; i < inner.size(); ++i)
  {
    inner[i] = !border[i] && connectivity.vertex_triangles.size(static_cast<int>(i)) > 0;
  }
  return inner;
}

/// Where the vertex and all its neighbours are valid.
Mask with_valid_neighbours(const Mask& valid, const AdjacencyList& neighbours)
{
  Mask result = valid;
  for (std::size_t i = 0; i < valid.size(); ++i)
  {
    const int vertex = static_cast<int>(i);
    for (const int* j = neighbours.begin(vertex); j != neighbours.end(vertex); ++j)
    {
      result[i] = result[i] && valid[*j];
    }
  }
  return result;
}

/// Zero and invalid where a value is not a number (degenerate triangles).
void drop_invalid(Eigen::VectorXd& values, Mask& valid)
{
  for (Eigen::Index i = 0; i < values.size(); ++i)
  {
    valid[i] = valid[i] && std::isfinite(values[i]);
    values[i] = valid[i] ? values[i] : 0;
  }
}

vtkSmartPointer<vtkUnsignedCharArray> mask_array(const char* name, const Mask& mask)
{
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetName(name);
  for (const bool valid : mask)
  {
    array->InsertNextValue(valid);
  }
  return array;
}

/// Adds arrays that aren't defined at all vertices, where they are 0, or NaN if so wanted.
struct PartlyDefined
{
  vtkPointData* arrays;
  bool undefined_is_nan;

  void add(const char* name, Eigen::MatrixXd values, const Mask& valid) const
  {
    for (Eigen::Index i = 0; undefined_is_nan && i < values.rows(); ++i)
    {
      if (!valid[i])
      {
        values.row(i).setConstant(std::numeric_limits<double>::quiet_NaN());
      }
    }
    arrays->AddArray(to_array(name, values));
  }
};

/// What a scheme gives.
struct Computed
{
  Curvature curvature;
  Points direction;           ///< of the greatest normal curvature; no rows: unknown
  Eigen::VectorXd mean_error; ///< standard error of the mean curvature; no rows: unknown
  std::string remark;
};

std::string percent(double share)
{
  return fmt::format("{:.0f}%", 100 * share);
}

/// Two digits, upwards.
double rounded_up(double x)
{
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  return std::ceil(x / unit) * unit;
}

std::string noise_remark(const TriangleMesh& mesh, const Connectivity& connectivity,
  const FittedCurvature& fit, double radius)
{
  constexpr double bearable = 0.05, wanted = 0.03; // typical errors
  const double error = typical_error(mesh, fit);
  if (error <= bearable)
  {
    return {};
  }
  const auto better = radius_for_error(mesh, connectivity, wanted);
  if (!better || *better <= radius)
  {
    return {};
  }
  return fmt::format(
    "the points are too noisy for this fit: at half of them the standard error of the "
    "mean curvature is {} of the curvature or more; with a fit radius "
    "(FitRadius, --radius) of {:g}, {:.1f} mean edges, it would be {}",
    percent(error), rounded_up(*better),
    *better / mean_edge(mesh.points, connectivity.vertex_neighbours), percent(wanted));
}

Computed fitted(const TriangleMesh& mesh, const Connectivity& connectivity,
  const CurvatureSettings& settings, const ProgressCallback& progress, vtkPointData* arrays)
{
  FitOptions options;
  options.radius = settings.fit_radius > 0
    ? settings.fit_radius
    : settings.fit_rings * mean_edge(mesh.points, connectivity.vertex_neighbours);
  options.laplacian = settings.bending_force;
  FittedCurvature fit = fitted_curvature(mesh, connectivity, options, progress);
  arrays->AddArray(to_array("Fit_Residual", fit.residual));
  arrays->AddArray(to_array("Fit_Degree", Eigen::VectorXd(fit.degree.cast<double>())));
  std::string remark = noise_remark(mesh, connectivity, fit, options.radius);
  return { std::move(fit.curvature), std::move(fit.direction), std::move(fit.mean_error),
    std::move(remark) };
}

/// By the scheme's name; the fit adds its own arrays.
Computed computed(const TriangleMesh& mesh, const Connectivity& connectivity,
  const CurvatureSettings& settings, const ProgressCallback& progress, vtkPointData* arrays)
{
  switch (settings.scheme)
  {
    case vtkVesicleCurvatureFilter::Cotan:
      return { cotan_curvature(CotanGeometry(mesh.points, mesh.triangles), mesh.points,
                 NormalScheme::area_weighted),
        {}, {}, {} };
    case vtkVesicleCurvatureFilter::Loop:
      return { loop_curvature(mesh, progress), {}, {}, {} };
    default:
      return fitted(mesh, connectivity, settings, progress, arrays);
  }
}

void add_bending_force(Curvature& curvature, const Mask& valid, const Connectivity& connectivity,
  double rigidity, const PartlyDefined& to)
{
  Mask force_valid = with_valid_neighbours(valid, connectivity.vertex_neighbours);
  drop_invalid(curvature.laplacian_mean, force_valid);
  Eigen::VectorXd density = rigidity * bending_density(curvature);
  drop_invalid(density, force_valid);
  const Points force = curvature.normal.array().colwise() * density.array();
  to.add("Laplacian_Mean_Curvature", curvature.laplacian_mean, force_valid);
  to.add("Bending_Force", force, force_valid);
  to.arrays->AddArray(mask_array("Bending_Force_Valid", force_valid));
}

/// (κ1 − κ2)/2; the fits leave H² − K below 0 at most by their error.
Eigen::ArrayXd half_difference(const Curvature& curvature)
{
  return (curvature.mean.array().square() - curvature.gauss.array()).max(0).sqrt();
}

void add_directions(const Points& greatest, const Curvature& curvature, const Mask& valid,
  bool inverted, const PartlyDefined& to)
{
  Points least(greatest.rows(), 3), most = greatest;
  for (Eigen::Index i = 0; i < most.rows(); ++i)
  {
    if (!valid[i])
    {
      most.row(i).setZero();
    }
    least.row(i) = curvature.normal.row(i).cross(most.row(i));
  }
  if (inverted)
  {
    most.swap(least);
  }
  to.add("Maximum_Direction", most, valid);
  to.add("Minimum_Direction", least, valid);
}

void add_shape_descriptors(const Curvature& curvature, const Mask& valid, const PartlyDefined& to)
{
  const Eigen::ArrayXd mean = curvature.mean, half = half_difference(curvature);
  Eigen::VectorXd index(mean.size());
  for (Eigen::Index i = 0; i < index.size(); ++i)
  {
    index[i] = 2 / std::numbers::pi * std::atan2(mean[i], half[i]); // 0 where both are
  }
  const Eigen::VectorXd curvedness = (mean.square() + half.square()).sqrt();
  const Eigen::VectorXd density = mean.square();
  to.add("Curvedness", curvedness, valid);
  to.add("Shape_Index", index, valid);
  to.add("Willmore_Density", density, valid);
}

}

const char* curvature_array_name(int type)
{
  constexpr const char* names[] = { "Gauss_Curvature", "Mean_Curvature", "Maximum_Curvature",
    "Minimum_Curvature" };
  return names[type];
}

std::string add_curvature_arrays(const TriangleMesh& mesh, const CurvatureSettings& settings,
  const ProgressCallback& progress, vtkPointData* arrays)
{
  const Connectivity connectivity(mesh.triangles, static_cast<int>(mesh.points.rows()));
  Computed found = computed(mesh, connectivity, settings, progress, arrays);
  Curvature& curvature = found.curvature;
  Mask valid = inner_vertices(connectivity);
  drop_invalid(curvature.mean, valid);
  drop_invalid(curvature.gauss, valid);
  drop_invalid(curvature.mean, valid);
  curvature.normal = curvature.normal.unaryExpr([](double n) { return std::isfinite(n) ? n : 0; });
  const PartlyDefined to{ arrays, settings.undefined_is_nan };
  to.add("Gauss_Curvature", curvature.gauss, valid);
  if (found.mean_error.size() > 0)
  {
    to.add("Mean_Curvature_Error", found.mean_error, valid);
  }
  arrays->AddArray(mask_array("Curvature_Valid", valid));
  if (settings.bending_force)
  {
    add_bending_force(curvature, valid, connectivity, settings.bending_rigidity, to);
  }
  if (settings.inverted)
  {
    curvature.mean = -curvature.mean;
  }
  to.add("Mean_Curvature", curvature.mean, valid);
  for (const int type : { VTK_CURVATURE_MAXIMUM, VTK_CURVATURE_MINIMUM })
  {
    if (settings.principal_curvatures || settings.type == type)
    {
      const double sign = type == VTK_CURVATURE_MAXIMUM ? 1 : -1;
      const Eigen::VectorXd principal = curvature.mean.array() + sign * half_difference(curvature);
      to.add(curvature_array_name(type), principal, valid);
    }
  }
  if (settings.principal_curvatures && found.direction.rows() > 0)
  {
    add_directions(found.direction, curvature, valid, settings.inverted, to);
  }
  if (settings.shape_descriptors)
  {
    add_shape_descriptors(curvature, valid, to);
  }
  arrays->SetNormals(to_array("Normals", curvature.normal));
  return found.remark;
}

}
