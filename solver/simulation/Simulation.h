#pragma once
// The vesicles of a scene: State in, State out.

#include "solver/dynamics/Diagnostics.h"
#include "solver/dynamics/OutputSchedule.h"
#include "solver/dynamics/Scales.h"
#include "solver/scene/Scene.h"
#include "solver/simulation/DimensionlessNumbers.h"
#include "solver/simulation/ErrorEstimate.h"
#include "solver/simulation/StartMesh.h"
#include "solver/dynamics/State.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vesicle
{

class Simulation
{
public:
  /// The start mesh of each vesicle, with notes on how it was made. Throws InputError, also where
  /// the machine's memory is too small or vesicles overlap.
  Simulation(const Scene& scene, const std::vector<StartMesh>& start);
  /// Of one vesicle: `start` is the start mesh in the scene's units, oriented outward (make_start_mesh gives it for
  /// scenes with a shape; scenes with a mesh file have it read by a reader). Throws InputError,
  /// also where the machine's memory is too small. `notes` (how the mesh was made, say) come before the simulation's own.
  Simulation(const Scene& scene, TriangleMesh start, const std::string& notes = {});
  ~Simulation();

  const Scene& scene() const;
  const Scales& scales() const;
  std::size_t vesicles() const;
  /// In the scene's units; of several vesicles one after the other.
  const TriangleMesh& start_mesh() const;
  /// Of each vesicle.
  std::vector<Triangles> start_triangles() const;
  /// What was changed in the start mesh and what is to be said of it, for the user; empty if
  /// nothing.
  const std::string& notes() const;
  const DimensionlessNumbers& numbers() const;
  /// The times that are hit exactly.
  const OutputSchedule& schedule() const;

  /// The start: time 0, velocity and tension solved for the start shape, with bending as implicit
  /// as the first step needs it.
  State start();
  /// The same with nothing of a time step in it: the bending force is that of the shape.
  State instant();
  /// Throws InputError unless the state is one of the start's mesh (a file's may have changed since), or
  /// of any closed one where meshes are laid anew.
  void require_own(const State& state) const;
  /// The state that the next step starts from: the same moment, laid on a new mesh where meshes are
  /// adaptive and the old one no longer does (MeshAdaptation.h), otherwise the state itself. Of itself
  /// it is itself.
  State ready(const State& state);
  /// One accepted step from ready(state). Throws NumericalError if there is none, or if at an output
  /// time, or after any step where meshes are adaptive, the membrane passes through itself or its mesh
  /// knows the bending energy to 10% only; `state` is then still valid.
  State step(const State& state);
  /// What the last step() that threw had come to, or null where it had come to nothing: not to go on from.
  const State* refused() const;
  /// What is to be said of a state whose mesh knows the bending energy to 1% only: where, and how
  /// many triangles it needs; empty if it knows better. Places are in units of r0.
  std::string unresolved_warning(const State& state);
  /// True at the scene's end time, or when the shape is steady (end = "steady").
  bool finished(const State& state);

  Diagnostics diagnose(const State& state, std::size_t vesicle = 0);
  /// Of each vesicle.
  std::vector<Diagnostics> diagnose_all(const State& state);
  /// Takes about as long as three steps; of several vesicles the worst. Throws NumericalError.
  ErrorEstimate error_estimate(const State& state);

  /// Positions between a state that is ready() and the next by cubic Hermite interpolation, in the
  /// scene's units.
  /// `time` in the scene's units, between the two states' times.
  Points points_between(const State& before, const State& after, double time) const;
  Points points(const State& state) const; ///< in the scene's units
  /// In the scene's units; of several vesicles one after the other, as points() and fields().
  TriangleMesh mesh(const State& state) const;
  /// Which vesicle, from 0, each point of mesh() is of.
  std::vector<int> vesicle_ids(const State& state) const;
  double time(const State& state) const; ///< in the scene's units

  /// Point fields of a state in the scene's units, by the names of the output contract
  /// (Mean_Curvature, Gauss_Curvature, Laplacian_Mean_Curvature, Normals, Bending_Force, Tension,
  /// Tension_Force, Membrane_Force, Gravity_Force, Velocity, Surface_Divergence); #vertices rows, 1
  /// or 3 columns. Only what the scene has: no Tension without incompressibility, no Bending_Force
  /// without bending, no Gravity_Force without gravity; of several vesicles what any of them has, 0 on
  /// the others. Throws NumericalError if a value isn't finite.
  std::map<std::string, Eigen::MatrixXd> fields(const State& state);

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}
