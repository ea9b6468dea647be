#include "solver/stokes/ForceDensity.h"

namespace vesicle
{

ForceDensity nodal_density(const Points& nodal)
{
  return [nodal](const BasisTable& table, const SurfacePoints&)
  { return interpolate(table, nodal); };
}

ForceDensity normal_density(const Eigen::VectorXd& nodal)
{
  return [nodal](const BasisTable& table, const SurfacePoints& s) -> RowVectors
  { return s.cross.rowwise().normalized().array().colwise() * interpolate(table, nodal).array(); };
}

// (γ_u (x_v × n) + γ_v (n × x_u))/J − 2 H γ n.
ForceDensity tension_density(const Points& control, const Eigen::VectorXd& nodal)
{
  return [control, nodal](const BasisTable& table, const SurfacePoints& s)
  {
    const Eigen::VectorXd mean = mean_curvature(table, s, control);
    RowVectors density(table.rows(), 3);
    for (int q = 0; q < table.rows(); ++q)
    {
      double value = 0, du = 0, dv = 0;
      for (int k = table.start[q]; k < table.start[q + 1]; ++k)
      {
        const double gamma = nodal[table.node[k]];
        value += table.value[k] * gamma;
        du += table.du[k] * gamma;
        dv += table.dv[k] * gamma;
      }
      const double J = s.cross.row(q).norm();
      const Eigen::RowVector3d n = s.cross.row(q) / J, a = s.tangent_u.row(q),
                               b = s.tangent_v.row(q);
      density.row(q) = (du * b.cross(n) + dv * n.cross(a)) / J - 2 * mean[q] * value * n;
    }
    return density;
  };
}

ForceDensity operator+(ForceDensity a, ForceDensity b)
{
  return [a = std::move(a), b = std::move(b)](const BasisTable& table,
           const SurfacePoints& s) -> RowVectors { return a(table, s) + b(table, s); };
}

}
