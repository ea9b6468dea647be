#include "solver/simulation/MeshAdaptation.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{

namespace
{

/// Disagreements at which a mesh is too coarse, and what a new one is to have.
constexpr double coarse = 1e-3, aim = 3e-4;
/// The smallest angle below which a mesh is laid anew whatever it holds.
constexpr double sharp = 25;
/// Steps that a finer mesh, and others, have to wait.
constexpr int pause = 5, long_pause = 20;
/// Not for less.
constexpr double worthwhile = 1.4;
/// Of the least number: meshes don't meet a number exactly.
constexpr double few = 0.9;

}

MeshAdaptation::MeshAdaptation(const Scene& scene, int triangles)
  : least_(scene.accuracy.least_triangles.value_or(triangles)),
    most_(std::max(least_, scene.accuracy.most_triangles.value_or(4 * triangles)))
{
}

// The disagreement falls as 1/N².
std::optional<int> MeshAdaptation::wanted(const State& state, const MeshFitness& fitness) const
{
  const auto triangles = static_cast<double>(state.vesicles[0].triangles.rows());
  const auto waited = state.step - state.remeshing.tried;
  const auto count = [&](double factor)
  { return std::clamp(static_cast<int>(factor * triangles), least_, most_); };
  if (waited < pause)
    return {};
  if (triangles < few * least_)
    return least_;
  const double d = fitness.disagreement;
  if (d > std::max(coarse, 2 * state.remeshing.disagreement))
    return count(std::clamp(std::sqrt(d / aim), worthwhile, 4.));
  if (fitness.angle < sharp / 2)
    return count(1);
  if (waited < long_pause)
    return {};
  if (fitness.angle < sharp)
    return count(1);
  const double fewer = std::sqrt(2 * d / aim);
  if (fewer < 1 / worthwhile && count(fewer) < triangles / worthwhile)
    return count(fewer);
  return {};
}

std::vector<int> MeshAdaptation::wanted_triangles(
  const State& state, const MeshFitness& fitness) const
{
  const std::optional<int> first = wanted(state, fitness);
  if (!first)
    return {};
  const int next = std::min(most_, static_cast<int>(worthwhile * *first));
  return next > *first ? std::vector{ *first, next } : std::vector{ *first };
}

bool MeshAdaptation::better(const MeshFitness& fresh, const MeshFitness& old) const
{
  return fresh.disagreement < std::max(coarse, old.disagreement) &&
    fresh.angle > std::min(sharp, old.angle);
}

}
