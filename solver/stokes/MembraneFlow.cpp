#include "solver/stokes/MembraneFlow.h"

#include "solver/surface/LoopBasis.h"
#include "solver/surface/SparseLU.h"

namespace vesicle
{

namespace
{

/// Values at the rows from those at the nodes: rows by columns of `nodal`.
template<class Values>
Values interpolated(const BasisTable& table, const Values& nodal)
{
  Values values = Values::Zero(table.rows(), nodal.cols());
  for (int q = 0; q < table.rows(); ++q)
    for (int k = table.start[q]; k < table.start[q + 1]; ++k)
      values.row(q) += table.value[k] * nodal.row(table.node[k]);
  return values;
}

FlowField linear_flow(const TriangleMesh& mesh, const VertexForces& forces)
{
  const LinearBasis basis(mesh.triangles, static_cast<int>(mesh.points.rows()));
  const RowVectors nodal = forces.total;
  return FlowField(SurfacePanels(basis, mesh.points,
    [&](const BasisTable& table, const SurfacePoints&) { return interpolated(table, nodal); }));
}

/// ∇_s γ − 2 H γ n at the rows: (γ_u (x_v × n) + γ_v (n × x_u))/J − 2 H γ n.
RowVectors tension_density(const BasisTable& table, const SurfacePoints& s,
  const Eigen::VectorXd& mean, const Eigen::VectorXd& tension)
{
  RowVectors density(table.rows(), 3);
  for (int q = 0; q < table.rows(); ++q)
  {
    double value = 0, du = 0, dv = 0;
    for (int k = table.start[q]; k < table.start[q + 1]; ++k)
    {
      const double gamma = tension[table.node[k]];
      value += table.value[k] * gamma;
      du += table.du[k] * gamma;
      dv += table.dv[k] * gamma;
    }
    const double J = s.cross.row(q).norm();
    const Eigen::RowVector3d n = s.cross.row(q) / J, a = s.tangent_u.row(q), b = s.tangent_v.row(q);
    density.row(q) = (du * b.cross(n) + dv * n.cross(a)) / J - 2 * mean[q] * value * n;
  }
  return density;
}

FlowField loop_flow(const TriangleMesh& mesh, const VertexForces& forces)
{
  const LoopBasis basis(mesh.triangles, static_cast<int>(mesh.points.rows()));
  Eigen::SparseMatrix<double> P = basis.collocation();
  P.makeCompressed();
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> fit(P);
  const auto nodal = [&](const Eigen::MatrixXd& at_vertices) -> Eigen::MatrixXd
  { return fit.solve(at_vertices); };

  const Points control = nodal(mesh.points);
  const Points normal = basis.vertex_normals(control);
  const bool with_tension = forces.tension.size() > 0;
  const Points other = with_tension ? Points(forces.total - forces.tension_force) : forces.total;
  const Eigen::VectorXd pressure = other.cwiseProduct(normal).rowwise().sum();
  const Points rest = other - (normal.array().colwise() * pressure.array()).matrix();
  const Eigen::MatrixXd nodal_pressure = nodal(pressure);
  const RowVectors nodal_rest = nodal(rest);
  const Eigen::VectorXd tension =
    with_tension ? Eigen::VectorXd(nodal(forces.tension)) : Eigen::VectorXd();

  return FlowField(SurfacePanels(basis, control,
    [&](const BasisTable& table, const SurfacePoints& s)
    {
      RowVectors density = interpolated(table, nodal_rest);
      const Eigen::VectorXd p = interpolated(table, nodal_pressure);
      density += (s.cross.rowwise().normalized().array().colwise() * p.array()).matrix();
      if (with_tension)
        density += tension_density(table, s, mean_curvature(table, s, control), tension);
      return density;
    }));
}

}

FlowField membrane_flow(const TriangleMesh& mesh, Scene::Basis basis, const VertexForces& forces)
{
  return basis == Scene::Basis::loop ? loop_flow(mesh, forces) : linear_flow(mesh, forces);
}

}
