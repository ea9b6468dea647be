#pragma once
// The state of a run: plain data, all that a restart needs. A step is a function from State to
// State.

#include "solver/mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <cstdint>

namespace vesicle
{

/// Dimensionless (lengths in r0, steps in t0 = μ r0³/EB, tension in EB/r0², force densities in
/// EB/r0³, see Scales), but for the time, which is in the scene's units so that output times are
/// hit exactly.
struct State
{
  std::int64_t step = 0;   ///< accepted steps so far
  double time = 0;         ///< in the scene's units
  double last_step = 0;    ///< dt that led here; 0 at the start
  double next_step = 0;    ///< dt that the next step will try
  double free_step = 0;    ///< dt that the controller wants, were there no output time to hit
  std::int64_t output = 1; ///< index of the next output time, output · output_every

  Points points;   ///< #vertices by 3
  Points velocity; ///< #vertices by 3, of the fluid at the vertices
  /// #vertices by 3, of the vertices themselves (their tangential part is free).
  Points node_velocity;
  Eigen::VectorXd tension; ///< #vertices; empty without incompressibility
  /// #vertices, normal bending force density as used by the dynamics; empty without bending.
  Eigen::VectorXd bending;
  /// Size 1: multiplier c of the volume row; size 0 in the paper scheme.
  Eigen::VectorXd volume_speed;

  double target_area = 0;
  double target_volume = 0;
  double area_correction = 0; ///< relative, what projections have removed so far, summed absolutely
  double volume_correction = 0;

  std::int64_t iterations = 0; ///< of the linear solver in the last step
  std::int64_t rejected = 0;   ///< steps rejected so far

  /// The shape and time step whose factorisation preconditions the linear solver. Part of the state
  /// so that a restarted run repeats the uninterrupted one bit for bit.
  Points preconditioner_points;
  double preconditioner_step = 0;
};

}
