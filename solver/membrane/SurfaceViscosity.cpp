#include "solver/membrane/SurfaceViscosity.h"

#include "solver/surface/TangentFrame.h"

namespace vesicle
{

// In an orthonormal frame t, s of the tangent plane 2 e:e = (e_tt − e_ss)² + (2 e_ts)².
SparseMatrix viscosity_matrix(const Surface& surface, double viscosity)
{
  const BasisTable& table = surface.space->table();
  const SurfacePoints& points = surface.points;
  return element_sum<3, 3>(table,
    [&](ElementSum<3, 3>& sum, int q, int first, int width)
    {
      const TangentFrame frame(points, q);
      thread_local EntryVectors elongation, shear;
      elongation.resize(width, 3);
      shear.resize(width, 3);
      for (int k = 0; k < width; ++k)
      {
        const auto strain = frame.strain(table.du[first + k], table.dv[first + k]);
        elongation.row(k) = strain.elongation;
        shear.row(k) = strain.shear;
      }
      const double factor = viscosity * points.area_weight[q];
      sum.add_outer_product(factor, elongation.data(), elongation.data());
      sum.add_outer_product(factor, shear.data(), shear.data());
    });
}

}
