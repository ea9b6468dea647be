#pragma once
// When a run's mesh is laid anew, and with how many triangles.

#include "solver/dynamics/State.h"
#include "solver/scene/Scene.h"

namespace vesicle
{

/// How well a mesh holds its shape.
struct MeshFitness
{
  double disagreement; ///< of its bending energies by two rules (LoopEnergy.h)
  double angle;        ///< the smallest, in degrees
};

/// Bending energies by 3 and by 12 points an element tell in time that a mesh loses its shape: they
/// differ by 8e-3 four steps before a tip that was no longer held ran away, when the smallest angle was
/// still 40°. One change of the connectivity costs as much as a whole new mesh; so meshes are laid anew
/// as a whole, and rarely.
class MeshAdaptation
{
public:
  /// `triangles`: the start mesh's.
  MeshAdaptation(const Scene& scene, int triangles);

  int most_triangles() const { return most_; }
  /// How many a new mesh for this state is to have, and if that one isn't better(), the next; none: its
  /// own mesh does. They follow from the state alone.
  std::vector<int> wanted_triangles(const State& state, const MeshFitness& fitness) const;
  /// Whether a new mesh is worth its while.
  bool better(const MeshFitness& fresh, const MeshFitness& old) const;

private:
  std::optional<int> wanted(const State& state, const MeshFitness& fitness) const;

  int least_, most_;
};

}
