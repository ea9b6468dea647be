#pragma once
// The linear problem of one stage of a time step on smooth surfaces: at a frozen shape, the
// velocities u of the control points that the loads make, with tension, volume and the stiff terms'
// change over a time τ. With A = P⁻¹ S M⁻¹, S the single layer at the vertices (VesicleLoads.h):

// clang-format off
//
//   u = u∞ + A l + c n̂
//   l = l₀ − τ Qᵀ K Q (u − reference) − EᵀT E u − B̂ᵀγ − p Qᵀv
//   B̂ u − F γ = 0,   Qᵀv·u = 0,   n̂·l = 0
//
// clang-format on

// so that, for no flow and no tangential motion, dE/dt = g·Qu = −l·A l − γ·Fγ can't be positive.
// (T only of a taut sphere.) Unknowns, of each vesicle: ν = E u (NodeMotion.h), which is all that K feels, the tension γ, the
// pressure p and c; parts that it doesn't need aren't there.

#include "solver/dynamics/StageSolution.h"
#include "solver/dynamics/State.h"
#include "solver/dynamics/SystemShape.h"
#include "solver/stokes/PointSum.h"

#include <functional>

namespace vesicle
{

class LocalPreconditioner;

/// Of one vesicle; as a residual: of the rows that belong to them.
struct LoadUnknowns
{
  Eigen::VectorXd parameters, tension; ///< ν, γ; empty: none
  double pressure = 0, volume_speed = 0;
};

/// The velocities at all vertices (3N) that force densities at the nodes of each vesicle make, with at
/// least that precision.
using LayerMap = std::function<Eigen::VectorXd(const std::vector<Eigen::VectorXd>&, Precision)>;

class LoadStage
{
public:
  /// All arguments must outlive the stage. `tau`: implicit time; 0: stiff loads are those of the
  /// shape. `reference`: velocities of all vertices, or empty. `guess`: what has velocities and tensions
  /// near the solution, which is found from there with fewer iterations; or without any.
  LoadStage(const SystemShape& shape, LayerMap layer, double tau, const Eigen::VectorXd& reference,
    const State& guess);

  Eigen::Index unknowns() const { return first_.back(); }
  /// Solves to the velocity's relative error `tolerance`, about.
  StageSolution solve(const std::vector<LocalPreconditioner>& preconditioners, double tolerance,
    int max_iterations) const;

private:
  std::vector<LoadUnknowns> split(const Eigen::VectorXd& x) const;
  Eigen::VectorXd join(const std::vector<LoadUnknowns>& x) const;
  const VesicleLoads& loads(std::size_t vesicle) const { return *shape_.vesicles[vesicle].loads; }
  std::size_t count() const { return shape_.vesicles.size(); }
  bool has_parameters(std::size_t vesicle) const;
  LoadUnknowns unknowns_of(std::size_t vesicle, const State& guess) const;
  Eigen::VectorXd stiff_change(std::size_t vesicle, const Eigen::VectorXd& parameters) const;
  Eigen::VectorXd load_of(std::size_t vesicle, const LoadUnknowns& x) const;
  /// Rows of loads and the velocities that they and c make, without the flow.
  std::vector<LoadUnknowns> rows(const std::vector<Eigen::VectorXd>& loads,
    const std::vector<LoadUnknowns>& x, const Eigen::VectorXd& velocity) const;
  Eigen::VectorXd velocity_of(const std::vector<Eigen::VectorXd>& loads,
    const std::vector<LoadUnknowns>& x, Precision precision = Precision::full) const;

  StageSolution solution_of(const std::vector<LoadUnknowns>& x, int iterations) const;

  const SystemShape& shape_;
  LayerMap layer_;
  double tau_;
  std::vector<Eigen::Index> first_{ 0 };
  std::vector<Eigen::VectorXd> reference_load_; ///< τ Qᵀ K Q reference, or empty
  std::vector<Eigen::VectorXd> known_load_;
  std::vector<LoadUnknowns> guess_;
  Eigen::VectorXd scale_;
};

}
