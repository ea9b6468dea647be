// The single layer, by what is known exactly.

#include "apps/validate/Cases.h"

#include "solver/surface/LoopBasis.h"
#include "solver/mesh/shapes/Shapes.h"
#include "solver/stokes/LayerModes.h"
#include "solver/mesh/shapes/SampleMeshes.h"
#include "solver/stokes/StokesOperator.h"
#include "solver/surface/Collocation.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace vesicle::validation
{
namespace
{

/// The matrix from a density's values at the vertices to the velocities there.
struct Layer
{
  TriangleMesh mesh;
  DenseMatrix matrix;
  Eigen::VectorXd share; ///< ∮ f dS = Σ share · f at the vertices

  Layer(const TriangleMesh& m, bool loop) : mesh(m) { loop ? assemble_loop() : assemble_linear(); }

  Eigen::VectorXd nodal(const std::function<Vector3(const Vector3&)>& field) const
  {
    Eigen::VectorXd f(3 * mesh.points.rows());
    for (int i = 0; i < mesh.points.rows(); ++i)
    {
      f.segment<3>(3 * i) = field(mesh.points.row(i).transpose());
    }
    return f;
  }
  Eigen::VectorXd velocity(const Eigen::VectorXd& f) const { return multiply(matrix, to_nodes(f)); }
  /// ∮ f dS with S f = `velocity`.
  Vector3 total_force(const Eigen::VectorXd& velocity) const
  {
    const Eigen::VectorXd f = matrix.partialPivLu().solve(velocity);
    Vector3 sum = Vector3::Zero();
    for (int i = 0; i < share.size(); ++i)
    {
      sum += share[i] * f.segment<3>(3 * i);
    }
    return sum;
  }

private:
  void assemble_linear()
  {
    const LinearBasis basis(mesh.triangles, static_cast<int>(mesh.points.rows()));
    assemble(basis, mesh.points);
  }
  void assemble_loop()
  {
    const LoopBasis basis(mesh.triangles, static_cast<int>(mesh.points.rows()));
    collocation = std::make_shared<Collocation>(basis);
    assemble(basis, collocation->fit(mesh.points));
  }
  void assemble(const Basis& basis, const Points& control)
  {
    const LayerRules rules(basis, layer_quadrature(basis, 3)); // as in the dynamics
    matrix = StokesOperator({ { &rules, mesh.points, control } }).matrix(0);
    const BasisTable& table = rules.regular().table;
    share = vertex_areas(table, evaluate(table, control));
  }
  Eigen::VectorXd to_nodes(const Eigen::VectorXd& f) const
  {
    return collocation ? collocation->to_control(f) : f;
  }

  std::shared_ptr<const Collocation> collocation;
};

// Errors at 1,280 triangles and order in N. A linear density limits flat elements to h²; Loop's
// surface is of second order at extraordinary vertices only.
struct OperatorLimits
{
  double eigenvalue, pressure, drag, order;
};
constexpr OperatorLimits linear_limits{ 3e-2, 1e-3, 1e-2, 0.85 };
constexpr OperatorLimits loop_limits{ 3e-4, 1e-4, 2.5e-4, 1.2 };

double eigen_error(const Layer& layer, const LayerMode& mode)
{
  const Eigen::VectorXd f = layer.nodal(mode.field);
  return (layer.velocity(f) - mode.eigenvalue * f).norm() / (mode.eigenvalue * f).norm();
}

void eigenvalues(Report& report, bool loop)
{
  const OperatorLimits& limits = loop ? loop_limits : linear_limits;
  const Layer coarse(smooth_sphere(320), loop), fine(smooth_sphere(1280), loop);
  for (const LayerMode& mode : sphere_layer_modes())
  {
    const Eigen::VectorXd f = fine.nodal(mode.field);
    const double computed = fine.velocity(f).dot(f) / f.squaredNorm();
    report.add(relative(mode.name, mode.eigenvalue, computed, limits.eigenvalue));
    const double order =
      std::log(eigen_error(coarse, mode) / eigen_error(fine, mode)) / std::log(4);
    report.add(at_least(fmt::format("{}: order in N", mode.name), limits.order, order));
  }
  const double pressure =
    fine.velocity(fine.nodal([](const Vector3& x) { return x; })).cwiseAbs().maxCoeff();
  report.add(at_most("velocity of f = n", limits.pressure, pressure));
}

void drag(Report& report, bool loop)
{
  const OperatorLimits& limits = loop ? loop_limits : linear_limits;
  ShapeRequest request;
  request.kind = ShapeRequest::Kind::ellipsoid;
  request.semi_axes = { 2, 1, 1 };
  request.triangles = report.triangles();
  TriangleMesh mesh = make_shape(request);
  const Vector3 x = mesh.points.row(0); // all vertices lie on an ellipsoid of these proportions
  mesh.points /= Vector3(x[0] / 2, x[1], x[2]).norm();
  const Layer layer(mesh, loop);
  const double exact[] = { 22.693753013, 25.991634884 };
  const char* names[] = { "along", "across" };
  for (int axis = 0; axis < 2; ++axis)
  {
    const Vector3 e = Vector3::Unit(axis);
    const double computed = layer.total_force(layer.nodal([&](const Vector3&) { return e; }))[axis];
    report.add(relative(fmt::format("{}, {}", names[axis], report.triangles()), exact[axis],
      computed, report.full() ? limits.drag : 4 * limits.drag));
  }
}

}

std::vector<Case> operator_cases()
{
  std::vector<Case> cases;
  for (const bool loop : { false, true })
  {
    const std::string basis = loop ? "loop" : "linear";
    cases.push_back({ "layer/eigenvalues-" + basis,
      "Eigenvalues of the single layer on the unit sphere, basis " + basis, Case::Set::fast,
      [loop](Report& report) { eigenvalues(report, loop); } });
    cases.push_back({ "layer/drag-" + basis,
      "Drag of the ellipsoid 2, 1, 1 (Happel & Brenner 5-11), basis " + basis, Case::Set::fast,
      [loop](Report& report) { drag(report, loop); } });
  }
  return cases;
}

}
