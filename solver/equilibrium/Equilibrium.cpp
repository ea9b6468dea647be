#include "solver/equilibrium/Equilibrium.h"

#include "solver/Errors.h"
#include "solver/equilibrium/BorderedSystem.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{

namespace
{

constexpr int modes = 6;
constexpr int most_normal_steps = 40, most_slides = 12, most_descents = 400;
// Lengths in edge lengths of the mesh.
constexpr double largest_move = 0.3; // triangles stay triangles
constexpr double near = 1e-2;        // Newton's method has taken over
constexpr double at_rest = 1e-7;
// Area and volume, relative.
constexpr double kept = 1e-12;
// A slide of the mesh that gains less of the energy isn't worth its time.
// Of the energy, over the number of nodes, as the mesh's own error is: a slide that gains less isn't
// worth its time.
constexpr double least_gain = 3e-3;
// What keeps a node of mean area from sliding far, EB/r0²: an energy of about κ² h² a vertex changes
// over a distance h.
constexpr double first_slip = 0.1, least_slip = 0.025;

struct Step
{
  Eigen::VectorXd displacement; ///< 3N, in frames
  Multipliers multipliers;
  double gain = 0; ///< by which the Lagrangian falls, to second order
  double kept = 0; ///< by the shifts, of that gain: about what the next step has to gain
  double move = 0; ///< in edge lengths
};

class Search
{
public:
  Search(const EnergyProblem& problem, const Points& vertices, const EquilibriumObserver& observer)
    : problem_(problem), observer_(observer), second_(problem.space.table()),
      point_(problem, rows_of_three(problem.space.collocation().to_control(flat(vertices)))),
      multipliers_(point_.best_multipliers())
  {
  }

  void approach();
  void slide();
  void settle();
  void descend();
  Equilibrium finish();

private:
  Step step_of(const BorderedSystem& system, const Eigen::VectorXd& gradient,
    const Eigen::VectorXd& shift, Eigen::Index borders) const;
  void factorise_normal();
  Step normal_step() const;
  Step full_step(double normal_shift, double tangential_shift, int index);
  bool lowers(const Step& step) const;
  void accept(const Step& step);
  double lagrangian(const EnergyMeasures& at, const Multipliers& m) const;
  Eigen::VectorXd off_target(Eigen::Index borders) const;
  double largest_move_of(const Eigen::VectorXd& displacement) const;
  void linearise();

  const EnergyProblem& problem_;
  const EquilibriumObserver& observer_;
  SecondVariation second_;
  EnergyPoint point_;
  Multipliers multipliers_;
  Eigen::SparseMatrix<double> hessian_;
  NormalBorder normal_border_;
  BorderedSystem normal_system_, full_system_;
  int normal_index_ = 0;
  int steps_ = 0;
};

void Search::linearise()
{
  hessian_ = point_.lagrangian_hessian(second_, multipliers_);
  factorise_normal();
}

Eigen::VectorXd Search::off_target(Eigen::Index borders) const
{
  Eigen::VectorXd c = Eigen::VectorXd::Zero(borders);
  c[0] = problem_.area - point_.area;
  c[1] = problem_.volume - point_.volume;
  return c;
}

double Search::largest_move_of(const Eigen::VectorXd& displacement) const
{
  double largest = 0;
  for (Eigen::Index i = 0; i < point_.vertex_area.size(); ++i)
    largest = std::max(largest,
      displacement.segment<3>(3 * i).norm() / std::sqrt(point_.vertex_area[i] * 2 / std::sqrt(3.)));
  return largest;
}

/// Of normal displacements alone: factorised, and how many directions go downhill from here.
void Search::factorise_normal()
{
  normal_border_ = normal_border(point_);
  normal_system_.compute(normal_part(hessian_), normal_border_.columns, normal_border_.D);
  normal_index_ = normal_system_.index();
}

/// By the factors of here, or of a place near by.
Step Search::normal_step() const
{
  const Eigen::VectorXd gradient =
    point_.lagrangian_gradient(multipliers_)(Eigen::seq(0, Eigen::last, 3));
  const auto solution = normal_system_.solve(-gradient, off_target(normal_border_.D.size()));
  Step step;
  step.displacement = Eigen::VectorXd::Zero(3 * gradient.size());
  step.displacement(Eigen::seq(0, Eigen::last, 3)) = solution.x;
  step.multipliers = { multipliers_.tension + solution.y[0],
    multipliers_.pressure - solution.y[1] };
  step.gain = -gradient.dot(solution.x) / 2;
  step.move = largest_move_of(step.displacement);
  return step;
}

/// A step of all nodes in all directions, with shifts that keep it short; the tangential one is
/// raised until no more than `index` directions go downhill.
Step Search::full_step(double normal_shift, double tangential_shift, int index)
{
  const Eigen::MatrixXd rigid = point_.rigid_motion();
  const bool added = point_.mean_gradient.size() > 0;
  Eigen::MatrixXd B(rigid.rows(), 8 + (added ? 1 : 0));
  B << point_.area_gradient, point_.volume_gradient, rigid,
    Eigen::MatrixXd(rigid.rows(), added ? 1 : 0);
  Eigen::VectorXd D = Eigen::VectorXd::Zero(B.cols());
  if (added)
  {
    B.col(8) = point_.mean_gradient;
    D[8] = 1 / point_.membrane.mean_stiffness;
  }
  Eigen::VectorXd shift(3 * point_.vertex_area.size());
  constexpr double most = 1e12;
  const double mean_area = point_.vertex_area.mean();
  for (;; normal_shift *= normal_shift > 0 ? 4 : 1, tangential_shift *= 4)
  {
    for (Eigen::Index i = 0; i < point_.vertex_area.size(); ++i)
    {
      const double slip = tangential_shift * std::pow(mean_area / point_.vertex_area[i], 2);
      shift.segment<3>(3 * i) << normal_shift * point_.vertex_area[i], slip, slip;
    }
    Eigen::SparseMatrix<double> K = hessian_;
    K.diagonal() += shift;
    full_system_.compute(K, B, D);
    if (full_system_.index() <= index)
      break;
    if (tangential_shift > most)
      throw NumericalError("the mesh has no step that lowers its energy: take more triangles");
  }
  const Eigen::VectorXd gradient = point_.lagrangian_gradient(multipliers_);
  const auto solution = full_system_.solve(-gradient, off_target(B.cols()));
  Step step;
  step.displacement = solution.x;
  step.multipliers = { multipliers_.tension + solution.y[0],
    multipliers_.pressure - solution.y[1] };
  step.kept = solution.x.dot(shift.cwiseProduct(solution.x)) / 2;
  step.gain = step.kept - gradient.dot(solution.x) / 2;
  step.move = largest_move_of(step.displacement);
  return step;
}

double Search::lagrangian(const EnergyMeasures& at, const Multipliers& m) const
{
  return at.energy + m.tension * (at.area - problem_.area) -
    m.pressure * (at.volume - problem_.volume);
}

bool Search::lowers(const Step& step) const
{
  const EnergyMeasures now{ point_.membrane.energy, point_.area, point_.volume },
    then = measure(problem_, point_.moved(step.displacement));
  return lagrangian(then, step.multipliers) < lagrangian(now, step.multipliers);
}

void Search::accept(const Step& step)
{
  if (observer_)
    observer_({ steps_, point_.membrane.energy, step.move });
  const double part = std::min(1., largest_move / step.move);
  point_ = EnergyPoint(problem_, point_.moved(part * step.displacement));
  multipliers_ = step.multipliers;
  ++steps_;
  if (!std::isfinite(point_.membrane.energy) || !std::isfinite(point_.area))
    throw NumericalError("the search for an equilibrium left all shapes");
}

/// Normal displacements alone, up to where Newton's method converges.
void Search::approach()
{
  for (int k = 0; k < most_normal_steps; ++k)
  {
    linearise();
    const Step step = normal_step();
    if (step.move < near)
      return;
    accept(step);
  }
  throw NumericalError("there is no equilibrium near this shape on this mesh: take more triangles, "
                       "or let the energy fall (minimise)");
}

/// With the mesh sliding along. `hessian_` and the normal directions' index are those of the point.
void Search::slide()
{
  const double per_gain =
    std::abs(point_.membrane.energy) / static_cast<double>(point_.vertex_area.size());
  double shift = first_slip;
  for (int k = 0; k < most_slides; ++k)
  {
    Step step = full_step(0, shift, normal_index_);
    while ((step.move > largest_move || !lowers(step)) && shift < 1e8)
    {
      shift *= 8;
      step = full_step(0, shift, normal_index_);
    }
    if (step.gain < least_gain * per_gain)
      return;
    accept(step);
    linearise();
    if (step.kept < least_gain * per_gain)
      return;
    shift = std::max(shift / 4, least_slip);
  }
}

/// To rest, with the factors of the first point as long as they bring it ten times nearer a step.
void Search::settle()
{
  double last = near;
  for (int k = 0; k < most_normal_steps; ++k)
  {
    const Step step = normal_step();
    accept(step);
    const double off =
      std::abs(point_.area / problem_.area - 1) + std::abs(point_.volume / problem_.volume - 1);
    if (step.move < at_rest && off < kept)
      return;
    if (step.move > last / 10)
      linearise();
    last = step.move;
  }
  throw NumericalError("the search for an equilibrium doesn't converge on this mesh: take more "
                       "triangles");
}

/// Downhill until Newton's method finds a minimum.
void Search::descend()
{
  double shift = 1;
  for (int k = 0; k < most_descents; ++k)
  {
    linearise();
    if (normal_step().move < near && normal_index_ == 0)
      return;
    Step step = full_step(shift, shift, 0);
    while ((step.move > largest_move || !lowers(step)) && shift < 1e12)
    {
      shift *= 4;
      step = full_step(shift, shift, 0);
    }
    accept(step);
    shift = std::max(shift / 4, 1e-3);
  }
  throw NumericalError("the search for a minimum of the energy takes too long on this mesh");
}

Equilibrium Search::finish()
{
  slide();
  settle();
  linearise();
  Eigen::VectorXd force = point_.lagrangian_gradient(multipliers_)(Eigen::seq(0, Eigen::last, 3));
  const double imbalance =
    std::sqrt(force.cwiseAbs2().cwiseQuotient(point_.vertex_area).sum() / point_.area);
  return { rows_of_three(problem_.space.collocation().to_vertices(flat(point_.control))),
    point_.membrane.energy, point_.area, point_.volume, multipliers_, imbalance, steps_,
    lowest_normal_modes(point_, problem_.space.table(), hessian_, modes) };
}

}

Equilibrium equilibrium_near(
  const EnergyProblem& problem, const Points& vertices, const EquilibriumObserver& observer)
{
  Search search(problem, vertices, observer);
  search.approach();
  return search.finish();
}

Equilibrium equilibrium_below(
  const EnergyProblem& problem, const Points& vertices, const EquilibriumObserver& observer)
{
  Search search(problem, vertices, observer);
  search.descend();
  return search.finish();
}

Points pushed_along_lowest_mode(const EnergyProblem& problem, const Equilibrium& from)
{
  constexpr double push = 0.05; // r0
  const Collocation& collocation = problem.space.collocation();
  const EnergyPoint point(problem, rows_of_three(collocation.to_control(flat(from.vertices))));
  const Eigen::VectorXd mode = from.modes.displacement.col(0);
  Eigen::VectorXd displacement = Eigen::VectorXd::Zero(3 * mode.size());
  displacement(Eigen::seq(0, Eigen::last, 3)) = push / mode.cwiseAbs().maxCoeff() * mode;
  return rows_of_three(collocation.to_vertices(flat(point.moved(displacement))));
}

}
