#pragma once
// The state of a run: plain data, all that a restart needs. A step is a function from State to
// State.

#include "solver/mesh/TriangleMesh.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace vesicle
{

/// One vesicle. Dimensionless: lengths in r0, tension in EB/r0², force densities in EB/r0³, see
/// Scales.
struct VesicleState
{
  Triangles triangles;     ///< another mesh has others
  Points points;           ///< #vertices by 3
  Points velocity;         ///< #vertices by 3, of the fluid at the vertices
  Points node_velocity;    ///< #vertices by 3, of the vertices (their tangential part is free)
  Eigen::VectorXd tension; ///< #vertices; empty without incompressibility
  /// Force density of the stiff terms (bending) as the dynamics used it: along the normal on flat
  /// triangles, #vertices, nodal vectors on smooth surfaces, 3 #vertices; empty without.
  Eigen::VectorXd stiff_force;
  double volume_speed = 0; ///< multiplier c of the volume row
  double pressure = 0;     ///< multiplier p of the volume's load; smooth surfaces only

  double target_area = 0;
  double target_volume = 0;
  double area_correction = 0; ///< relative, what projections have removed so far, summed absolutely
  double volume_correction = 0;
};

/// What is remembered of meshes that were laid anew.
struct RemeshingState
{
  std::int64_t count = 0;  ///< how often so far
  std::int64_t tried = 0;  ///< step after which it was done, or tried in vain, for the last time
  double disagreement = 0; ///< of the mesh that came out: of its bending energies by two rules
  double energy = 0;       ///< what the membrane's energy has changed by in all, in EB
};

/// What the step control remembers. Steps in t0 = μ r0³/EB.
struct ControllerState
{
  double last_step = 0;      ///< dt that led here; 0 at the start
  double next_step = 0;      ///< dt that the next step will try
  double free_step = 0;      ///< dt that is wanted, were there no output time to hit
  std::int64_t output = 1;   ///< index of the next output time, output · output_every
  std::int64_t rejected = 0; ///< steps rejected so far
};

/// The shape and time step whose factorisation preconditions the linear solver. Part of the state
/// so that a restarted run repeats the uninterrupted one bit for bit.
struct PreconditionerState
{
  std::vector<Points> points; ///< of each vesicle; without rows: none was made
  double step = 0;            ///< 0: to be made anew
};

struct State
{
  std::int64_t step = 0; ///< accepted steps so far
  /// In the scene's units, so that output times are hit exactly; all else is dimensionless.
  double time = 0;
  std::int64_t iterations = 0; ///< of the linear solver in the last step
  ControllerState controller;
  PreconditionerState preconditioner;
  RemeshingState remeshing;
  std::vector<VesicleState> vesicles;
};

}
