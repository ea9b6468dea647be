#include "render/Model.h"

#include "render/SurfaceMeasures.h"
#include "vtkfilters/Filters/MeshConversion.h"

#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{
namespace
{

constexpr int shades = 256;

/// Of sRGB, IEC 61966-2-1.
double light(double c)
{
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

Points colors_of(vtkDataArray* array, const ColorScale& scale)
{
  const auto table = colors_of_range(scale, shades);
  const auto [low, high] = scale.range;
  Points colors(array->GetNumberOfTuples(), 3);
  for (Eigen::Index i = 0; i < colors.rows(); ++i)
  {
    const double share = std::clamp((scalar_value(array, i) - low) / (high - low), 0., 1.);
    const Color& color = table[static_cast<std::size_t>(std::lround(share * (shades - 1)))];
    for (int k = 0; k < 3; ++k)
    {
      colors(i, k) = light(color[k]);
    }
  }
  return colors;
}

Points normals_of(vtkPolyData* surface)
{
  const auto normals = point_normals(surface);
  Points rows(static_cast<Eigen::Index>(normals.size()), 3);
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
  {
    rows.row(i) = Eigen::Map<const Eigen::RowVector3d>(normals[i].data());
  }
  return rows;
}

}

Model model_of(vtkPolyData* triangles, const std::string& array, const ColorScale& scale)
{
  const TriangleMesh mesh = to_mesh(triangles);
  const Point3 centroid = surface_centroid(triangles);
  Model model;
  model.place = vector_of(centroid);
  model.points = mesh.points.rowwise() - model.place.transpose();
  model.normals = normals_of(triangles);
  model.colors = colors_of(finite_point_array(triangles, array), scale);
  model.triangles = mesh.triangles;
  return model;
}

}
