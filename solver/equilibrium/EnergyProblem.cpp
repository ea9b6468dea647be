#include "solver/equilibrium/EnergyProblem.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace vesicle
{

namespace
{

CurvatureEnergy sum_of(const MembraneTerms& terms, const CurvedPoints& surface)
{
  CurvatureEnergy sum(surface.twice_mean.size());
  for (const auto& term : terms)
    term->add_curvature_energy(surface, sum);
  return sum;
}

CurvatureDensity area_density(Eigen::Index rows)
{
  CurvatureDensity density(rows);
  density.value.setOnes();
  return density;
}

CurvatureDensity mean_density(const CurvedPoints& surface)
{
  CurvatureDensity density(surface.twice_mean.size());
  density.value = surface.twice_mean / 2;
  density.slope.setConstant(0.5);
  return density;
}

}

EnergyPoint::EnergyPoint(const EnergyProblem& problem, const Points& at)
  : control(at), surface(problem.space.table(), at), membrane(sum_of(problem.terms, surface)),
    area(vesicle::area(surface.points)),
    volume(vesicle::volume(problem.space.table(), surface.points)),
    frames(frames_along(problem.space.basis().vertex_normals(at))),
    vertex_area(vertex_areas(problem.space.table(), surface.points))
{
  const BasisTable& table = problem.space.table();
  gradient = in_frames(curvature_gradient(table, surface, membrane.density));
  area_gradient = in_frames(curvature_gradient(table, surface, area_density(table.rows())));
  volume_gradient = in_frames(vesicle::volume_gradient(table, surface.points));
  if (membrane.mean_stiffness != 0)
    mean_gradient = in_frames(curvature_gradient(table, surface, mean_density(surface)));
}

Points EnergyPoint::moved(const Eigen::VectorXd& displacement) const
{
  Points result = control;
  for (Eigen::Index i = 0; i < control.rows(); ++i)
    for (int k = 0; k < 3; ++k)
      result.row(i) += displacement[3 * i + k] * frames.row(i).segment<3>(3 * k);
  return result;
}

Eigen::VectorXd EnergyPoint::in_frames(const Eigen::VectorXd& functional) const
{
  Eigen::VectorXd result(functional.size());
  for (Eigen::Index i = 0; i < control.rows(); ++i)
    for (int k = 0; k < 3; ++k)
      result[3 * i + k] =
        functional.segment<3>(3 * i).dot(frames.row(i).segment<3>(3 * k).transpose());
  return result;
}

Eigen::SparseMatrix<double> EnergyPoint::lagrangian_hessian(
  const SecondVariation& second, const Multipliers& m) const
{
  CurvatureDensity density = membrane.density;
  density.value.array() += m.tension;
  return second.matrix(surface, density, m.pressure, frames);
}

Multipliers EnergyPoint::best_multipliers() const
{
  const auto normal = [&](const Eigen::VectorXd& v)
  { return v(Eigen::seq(0, Eigen::last, 3)).cwiseQuotient(vertex_area.cwiseSqrt()).eval(); };
  const Eigen::VectorXd g = normal(gradient), a = normal(area_gradient),
                        v = normal(volume_gradient);
  Eigen::Matrix2d gram;
  gram << a.dot(a), -a.dot(v), -a.dot(v), v.dot(v);
  const Eigen::Vector2d x = gram.fullPivLu().solve(Eigen::Vector2d(-a.dot(g), v.dot(g)));
  return { x[0], x[1] };
}

Eigen::MatrixXd EnergyPoint::rigid_motion() const
{
  Eigen::MatrixXd motion(3 * control.rows(), 6);
  const Eigen::RowVector3d center = vertex_area.transpose() * control / vertex_area.sum();
  for (Eigen::Index i = 0; i < control.rows(); ++i)
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::RowVector3d along = frames.row(i).segment<3>(3 * k);
      motion.row(3 * i + k).head<3>() = vertex_area[i] * along;
      motion.row(3 * i + k).tail<3>() = vertex_area[i] * (control.row(i) - center).cross(along);
    }
  return motion;
}

EnergyMeasures measure(const EnergyProblem& problem, const Points& control)
{
  const CurvedPoints surface(problem.space.table(), control);
  return { sum_of(problem.terms, surface).energy, area(surface.points),
    volume(problem.space.table(), surface.points) };
}

}
