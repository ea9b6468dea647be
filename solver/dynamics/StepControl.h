#pragma once
// When a step is accepted and how long the next one is.

#include <limits>
#include <string>

namespace vesicle
{

/// What one attempted step did, all dimensionless.
struct StepReport
{
  bool finite = true;
  double error = 0; ///< e = dt max|n·(u_mid − u_start)|, a length
  double displacement =
    0; ///< largest normal displacement of a node relative to the centroid, in edges
  double area_change = 0;     ///< |ΔA|/A before the projection
  double volume_change = 0;   ///< |ΔV|/V before the projection
  double constraint_left = 0; ///< of area and volume after it, relative
  double energy_rise = 0;     ///< relative, of the bending energy in a fluid at rest; 0 otherwise
  double energy_jump = 0;     ///< the same in a fluid that moves, or under a load
  /// Between the nearest vesicles, before and after, in mean edges; infinite where none are near.
  double gap_before = std::numeric_limits<double>::infinity(),
         gap = std::numeric_limits<double>::infinity();
  /// Between the wall and the vesicle nearest to it; infinite without a wall.
  double wall_gap_before = std::numeric_limits<double>::infinity(),
         wall_gap = std::numeric_limits<double>::infinity();
  std::string contact; ///< what has come too near, where, and what to try; empty: nothing
};

struct StepLimits
{
  double tolerance = 1e-3;       ///< of the position error a step, in r0
  double reject_error = 4;       ///< in tolerances: the estimate is of lower order than the step
  double displacement = 0.3;     ///< in mean edges: frozen coefficients hold no further
  double geometry_change = 2e-3; ///< area and volume: the step no longer follows the constraint
  double constraint_left = 1e-9; ///< the projection is good for 1e-13 where it succeeds
  double energy_rise = 1e-6;     ///< dissipation is the one thing a fluid at rest can do
  double energy_jump =
    0.25; ///< no flow bends a membrane by so much in a step: a mesh that folds over does
  /// No step takes more of what is between two vesicles, or one and a wall: one that did would have them
  /// cross.
  double gap_share = 0.5;
  /// In mean edges: nearer than that vesicles are in contact. Neither the forces, known at the vertices,
  /// nor the shapes tell more.
  double contact = 0.02;
  /// The same of a wall, against which the fluid in the gap holds a membrane with forces that peak.
  double wall_contact = 0.1;
  double growth = 1.5; ///< at most, from one step to the next
  double shrink = 0.3; ///< at most
  double safety = 0.9;
};

/// Why the step can't be accepted; empty if it can.
std::string reason_to_reject(const StepReport& report, const StepLimits& limits);

/// The dt that the report on a step `taken` asks for: the error's estimate grows as dt², a rise of
/// the energy as dt. It grows from `planned`, the step that the controller wanted when `taken` may
/// have been cut short to hit an output time: being cut short says nothing against longer steps.
double wanted_step(
  double taken, double planned, const StepReport& report, const StepLimits& limits);

/// dt shortened such that `time` + n dt hits `target`: the last two steps before it share what is
/// left.
double step_towards(double dt, double time, double target);

}
