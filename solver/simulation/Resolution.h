#pragma once
// Whether a run's mesh still holds its vesicle's shape: the error in space, told apart from that in
// time, which steps of any size can't cure.

#include "solver/surface/LoopEnergy.h"

#include <string>

namespace vesicle
{

/// Of a mesh's bending energy by two rules (LoopEnergy.h).
class Resolution
{
public:
  Resolution(const Triangles& triangles, int points);

  double disagreement(const Points& points) const { return rules_.energy(points).disagreement(); }
  /// What is to be said where the rules differ by more than `allowed`, with the place, in the points'
  /// units, and how many triangles are needed; empty if they don't.
  std::string complaint(const Points& points, double allowed) const;

private:
  LoopEnergyRules rules_;
  Eigen::Index triangles_;
};

}
