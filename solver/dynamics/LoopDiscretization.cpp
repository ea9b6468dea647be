#include "solver/dynamics/Discretization.h"

#include "solver/surface/FittedCurvature.h"
#include "solver/surface/LoopBasis.h"
#include "solver/surface/SparseLU.h"
#include "solver/membrane/Bending.h"
#include "solver/membrane/SurfaceBending.h"

#include <Eigen/SparseCholesky>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace vesicle
{

namespace
{

using ColumnMatrix = Eigen::SparseMatrix<double>;

// Levels by which elements at extraordinary vertices are refined for the geometry, which costs
// little.
constexpr int geometry_grading = 3;
constexpr int geometry_points = 6;
// Of the bending energy, its gradient and its Hessian. Around extraordinary vertices the surface
// can't follow the curvature and ripples; three points a triangle feel less of that than an exact
// integral. Relaxed prolates of 1,280 triangles have an energy 0.004, 0.001 and 0.002% too high at
// v = 0.8, 0.7 and 0.65, against 0.017, 0.015 and 0.008% with six points and graded elements.
constexpr int bending_points = 3;

// Bounds of the eigenvalues of P: 1/4 to 1 for valence six, a little lower for small valences.
constexpr double smallest_eigenvalue = 0.2, largest_eigenvalue = 1;
constexpr int chebyshev_sweeps = 6;
// A tension that alternates from node to node does next to no work on a smooth velocity, so the
// constraint leaves it free (a checkerboard). −filter h³ Δ_s² γ in the constraint's rows takes it
// out: at the scale of the mesh that is as large as what a smooth tension does there, and on smooth
// tensions of third order. The total area doesn't feel it. At 320 triangles in shear 1e-3 brings
// the tension from [3.3, 6.9] to [4.0, 6.6]; a hundred times more changes the inclination by 0.06°.
constexpr double tension_filter = 1e-3;

// Elements are cut in cuts² flat pieces where lines are measured on them: sixteen times nearer to
// the surface than the elements' own chords.
constexpr int cuts = 4;

// The element's corners and, behind them, the other points of the pieces.
struct CutElement
{
  std::vector<std::array<double, 2>> points{ { 0, 0 }, { 1, 0 }, { 0, 1 } }; ///< (u, v)
  std::vector<std::array<int, 3>> pieces;

  CutElement()
  {
    const auto point = [&](int i, int j)
    {
      const std::array<double, 2> uv{ double(i) / cuts, double(j) / cuts };
      const auto found = std::find(points.begin(), points.end(), uv);
      const auto index = static_cast<int>(found - points.begin());
      if (found == points.end())
        points.push_back(uv);
      return index;
    };
    for (int j = 0; j < cuts; ++j)
      for (int i = 0; i + j < cuts; ++i)
      {
        pieces.push_back({ point(i, j), point(i + 1, j), point(i, j + 1) });
        if (i + j < cuts - 1)
          pieces.push_back({ point(i + 1, j), point(i + 1, j + 1), point(i, j + 1) });
      }
  }

  int inner() const { return static_cast<int>(points.size()) - 3; } ///< all but the corners

  BasisTable tabulate(const Basis& basis) const
  {
    std::vector<ParametricPoint> all;
    for (int e = 0; e < basis.elements().rows(); ++e)
      for (auto uv = points.begin() + 3; uv != points.end(); ++uv)
        all.push_back({ e, (*uv)[0], (*uv)[1], 0 });
    return basis.tabulate(all);
  }
};

class LoopDiscretization final : public Discretization
{
public:
  LoopDiscretization(const Model& model, const Triangles& triangles, int nodes, int quadrature)
    : model_(model), basis_(triangles, nodes),
      geometry_(tabulate_rule(basis_, triangle_rule(geometry_points), geometry_grading)),
      bending_(tabulate_rule(basis_, triangle_rule(bending_points))),
      samples_(cut_.tabulate(basis_)), layer_(basis_, smooth_layer_quadrature(quadrature)),
      P_(basis_.collocation())
  {
    ColumnMatrix columns = P_;
    columns.makeCompressed();
    fit_.compute(columns);
    ColumnMatrix transposed = P_.transpose();
    transposed.makeCompressed();
    fit_transposed_.compute(transposed);
  }

  const BasisTable& table() const override { return geometry_; }

  ShapeOperators shape(const Points& vertices) const override
  {
    ShapeOperators s;
    s.vertices = vertices;
    s.control = rows_of_three(to_control(flat(vertices)));
    const SurfacePoints surface = evaluate(geometry_, s.control);
    const RowCurvature curvature = row_curvature(geometry_, surface, s.control);
    s.area = vesicle::area(surface);
    s.volume = vesicle::volume(geometry_, surface);
    s.center = centroid(geometry_, surface);
    s.vertex_area = vertex_areas(geometry_, surface);
    s.outward = basis_.vertex_normals(s.control);
    s.volume_gradient = from_control(volume_gradient(geometry_, surface));
    const auto W = centroid_velocity_matrix(geometry_, surface);
    s.centroid_velocity.resize(3, W.cols());
    for (int d = 0; d < 3; ++d)
      s.centroid_velocity.row(d) = from_control(W.row(d).transpose()).transpose();
    s.area_rate = area_rate_matrix(geometry_, surface);
    const SurfacePoints bent = evaluate(bending_, s.control);
    const RowCurvature bent_curvature = row_curvature(bending_, bent, s.control);
    s.bending_energy = vesicle::bending_energy(bent, bent_curvature);

    s.bending_mass = mass_matrix(geometry_, surface);
    const Eigen::SimplicialLDLT<ColumnMatrix> mass{ ColumnMatrix(s.bending_mass) };
    const auto project = [&](const Eigen::VectorXd& load) -> Eigen::VectorXd
    { return mass.solve(load); };
    const Eigen::VectorXd phi = project(bending_load(bending_, bent, bent_curvature));
    s.curvature.normal = s.outward;
    s.curvature.mean = at_vertices(project(moments(geometry_, surface, curvature.mean)));
    s.curvature.gauss = at_vertices(project(moments(geometry_, surface, curvature.gauss)));
    const auto H = s.curvature.mean.array();
    s.curvature.laplacian_mean =
      at_vertices(phi).array() / 2 - 2 * H * (H * H - s.curvature.gauss.array());
    if (model_.fitted_bending)
      s.curvature = fitted_curvature({ vertices, basis_.elements() }).curvature;
    if (model_.bending)
    {
      s.bending =
        model_.fitted_bending ? Eigen::VectorXd(fit_.solve(bending_density(s.curvature))) : phi;
      s.bending_response =
        along_normals(bending_hessian(bending_, bent, bent_curvature), s.outward);
    }
    if (model_.incompressible)
    {
      s.gauge_pinned = nearly_sphere(vertices, s.center);
      s.divergence = s.area_rate;
      const double h = std::sqrt(s.area / static_cast<double>(basis_.elements().rows()));
      s.divergence_filter =
        -tension_filter * h * h * h * bilaplacian(geometry_, surface, curvature);
    }
    if (model_.bond != 0) // z = Σ N_k c_k exactly
      s.load = model_.bond * (s.control.col(2).array() - s.center.z());
    if (model_.flow)
      s.ambient = flat(model_.flow->velocities(vertices));
    return s;
  }

  Constraints constraints(const Points& vertices) const override
  {
    const Points control = rows_of_three(to_control(flat(vertices)));
    const SurfacePoints surface = evaluate(geometry_, control);
    const Eigen::VectorXd mass = vertex_areas(geometry_, surface);
    const Points normal = basis_.vertex_normals(control);
    const Eigen::VectorXd mean =
      moments(geometry_, surface, mean_curvature(geometry_, surface, control)).cwiseQuotient(mass);
    return { vesicle::area(surface), vesicle::volume(geometry_, surface),
      from_control(
        area_rate_matrix(geometry_, surface).transpose() * Eigen::VectorXd::Ones(vertices.rows())),
      from_control(volume_gradient(geometry_, surface)), scaled_rows(normal, 2 * mean),
      flat(normal) };
  }

  double bending_energy(const Points& vertices) const override
  {
    const Points control = rows_of_three(to_control(flat(vertices)));
    const SurfacePoints surface = evaluate(bending_, control);
    return 2 * surface.area_weight.dot(mean_curvature(bending_, surface, control).cwiseAbs2());
  }

  void respond(const ShapeOperators& s, VelocityResponse& response) const override
  {
    layer_.respond_on_surface(
      s.vertices, s.control, model_.bending, model_.incompressible, s.load, response);
  }

  Eigen::VectorXd to_control(const Eigen::VectorXd& velocity) const override
  {
    return solve(fit_, velocity);
  }

  // Chebyshev iteration: each sweep is a product with P, and six leave an error of 0.2%.
  void to_control(RowsF& velocities) const override
  {
    const double centre = (largest_eigenvalue + smallest_eigenvalue) / 2,
                 radius = (largest_eigenvalue - smallest_eigenvalue) / 2, sigma = centre / radius;
    const RowsF b = velocities;
    RowsF direction = b / static_cast<float>(centre);
    RowsF x = direction;
    double rho = 1 / sigma;
    for (int sweep = 0; sweep < chebyshev_sweeps; ++sweep)
    {
      const double next = 1 / (2 * sigma - rho);
      RowsF residual = b;
      tbb::parallel_for(0, static_cast<int>(P_.rows()),
        [&](int i)
        {
          for (SparseMatrix::InnerIterator it(P_, i); it; ++it)
            residual.middleRows<3>(3 * i) -=
              static_cast<float>(it.value()) * x.middleRows<3>(3 * it.col());
        });
      direction = static_cast<float>(next * rho) * direction +
        static_cast<float>(2 * next / radius) * residual;
      x += direction;
      rho = next;
    }
    velocities = std::move(x);
  }

  Eigen::VectorXd bending_force(const ShapeOperators& s, const Eigen::VectorXd& phi) const override
  {
    return scaled_rows(s.outward, at_vertices(phi));
  }
  Eigen::VectorXd tension_force(
    const ShapeOperators& s, const Eigen::VectorXd& gamma) const override
  {
    // The density's nodal values by lumping: for output only, the dynamics use it pointwise.
    const Eigen::VectorXd nodal = -(s.area_rate.transpose() * gamma);
    return scaled_rows(rows_of_three(nodal), s.vertex_area.cwiseInverse());
  }
  Eigen::VectorXd load_force(const ShapeOperators& s) const override
  {
    return scaled_rows(s.outward, at_vertices(s.load));
  }
  double membrane_power(const ShapeOperators& s, const Eigen::VectorXd& phi,
    const Eigen::VectorXd& gamma, const Eigen::VectorXd& velocity) const override
  {
    double power = 0;
    if (phi.size() > 0)
      power += normal_power(s, phi, velocity);
    if (gamma.size() > 0) // ∮ f·v dS = −∮ γ ∇_s·v dS
      power -= gamma.dot(s.area_rate * to_control(velocity));
    return power;
  }
  double load_power(const ShapeOperators& s, const Eigen::VectorXd& velocity) const override
  {
    return normal_power(s, s.load, velocity);
  }
  FlatSample sample_around(
    double height, const ShapeOperators& s, const Points& field) const override
  {
    const Points control_field = rows_of_three(to_control(flat(field)));
    const std::vector<int> elements = elements_around(height, s.vertices);
    const Eigen::Index count = static_cast<Eigen::Index>(elements.size());
    FlatSample result;
    result.mesh.points.resize(count * cut_.points.size(), 3);
    result.field.resize(count * cut_.points.size(), 3);
    result.mesh.triangles.resize(count * cut_.pieces.size(), 3);
    int point = 0, piece = 0;
    for (const int e : elements)
    {
      for (const auto& [a, b, c] : cut_.pieces)
        result.mesh.triangles.row(piece++) << point + a, point + b, point + c;
      for (const int vertex : basis_.elements().row(e))
      {
        result.mesh.points.row(point) = s.vertices.row(vertex);
        result.field.row(point++) = field.row(vertex);
      }
      for (int row = e * cut_.inner(); row < (e + 1) * cut_.inner(); ++row)
      {
        result.mesh.points.row(point) = interpolate(samples_, row, s.control);
        result.field.row(point++) = interpolate(samples_, row, control_field);
      }
    }
    return result;
  }
  Eigen::VectorXd at_vertices(const Eigen::VectorXd& nodal) const override { return P_ * nodal; }

private:
  // Gradient with respect to the vertices from that with respect to the control points: P⁻ᵀ.
  Eigen::VectorXd from_control(const Eigen::VectorXd& gradient) const
  {
    return solve(fit_transposed_, gradient);
  }

  // Those whose corners reach the plane y = height, or nearly: an element bulges.
  std::vector<int> elements_around(double height, const Points& vertices) const
  {
    std::vector<int> around;
    for (int e = 0; e < basis_.elements().rows(); ++e)
    {
      const auto corners = vertices(basis_.elements().row(e), Eigen::all);
      const double bulge = 0.5 * (corners.row(0) - corners.row(1)).norm();
      if (corners.col(1).minCoeff() - bulge <= height &&
        height <= corners.col(1).maxCoeff() + bulge)
        around.push_back(e);
    }
    return around;
  }

  // ∮ p n·v dS for a nodal p.
  double normal_power(
    const ShapeOperators& s, const Eigen::VectorXd& nodal, const Eigen::VectorXd& velocity) const
  {
    const SurfacePoints surface = evaluate(geometry_, s.control);
    const Eigen::VectorXd density = interpolate(geometry_, nodal);
    return normal_load(geometry_, surface, density).dot(to_control(velocity));
  }

  static Eigen::VectorXd solve(
    const Eigen::SparseLU<ColumnMatrix>& factors, const Eigen::VectorXd& v)
  {
    const Eigen::MatrixXd columns = rows_of_three(v);
    const Points result = Eigen::MatrixXd(factors.solve(columns));
    return flat(result);
  }

  // −K 𝒩ᵀ: the response to the normal velocities of the nodes.
  static SparseMatrix along_normals(const SparseMatrix& K, const Points& normal)
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(3 * K.nonZeros());
    for (int i = 0; i < K.rows(); ++i)
      for (SparseMatrix::InnerIterator it(K, i); it; ++it)
        for (int d = 0; d < 3; ++d)
          entries.emplace_back(i, 3 * it.col() + d, -it.value() * normal(it.col(), d));
    SparseMatrix R(K.rows(), 3 * K.cols());
    R.setFromTriplets(entries.begin(), entries.end());
    return R;
  }

  Model model_;
  LoopBasis basis_;
  BasisTable geometry_, bending_;
  CutElement cut_;
  BasisTable samples_;
  SingleLayer layer_;
  SparseMatrix P_;
  Eigen::SparseLU<ColumnMatrix> fit_, fit_transposed_;
};

}

std::unique_ptr<Discretization> make_loop_discretization(
  const Model& model, const Triangles& triangles, int nodes, int quadrature)
{
  return std::make_unique<LoopDiscretization>(model, triangles, nodes, quadrature);
}

}
