#include "solver/dynamics/System.h"

#include "solver/membrane/HelfrichBending.h"

#include <algorithm>

namespace vesicle
{

bool Vesicle::stiff() const
{
  return std::any_of(terms.begin(), terms.end(), [](const auto& term) { return term->stiff(); });
}

bool Vesicle::has_energy() const
{
  return std::any_of(
    terms.begin(), terms.end(), [](const auto& term) { return !term->external(); });
}

double Vesicle::energy(const Surface& surface) const
{
  if (!has_energy())
    return curvature_energy->energy(surface);
  double sum = 0;
  for (const auto& term : terms)
    if (!term->external())
      sum += term->energy(surface);
  return sum;
}

Vesicle make_vesicle(std::shared_ptr<const SurfaceSpace> space, int quadrature)
{
  Vesicle vesicle;
  const Basis& basis = space->basis();
  vesicle.layer = std::make_unique<LayerRules>(basis, layer_quadrature(basis, quadrature));
  vesicle.curvature_energy = make_bending(*space, 0);
  vesicle.space = std::move(space);
  return vesicle;
}

Vesicle make_vesicle_like(const Vesicle& other)
{
  Vesicle vesicle;
  vesicle.space = other.space;
  vesicle.layer = other.layer;
  vesicle.curvature_energy = make_bending(*vesicle.space, 0);
  return vesicle;
}

Vesicle make_vesicle(SurfaceBasis basis, const Triangles& triangles, int nodes, int quadrature)
{
  return make_vesicle(
    std::make_unique<SurfaceSpace>(basis, triangles, nodes, quadrature), quadrature);
}

double System::rate() const
{
  double rate = flow ? flow->imposed_rate() : 0;
  for (const Vesicle& vesicle : vesicles)
    for (const auto& term : vesicle.terms)
      rate = std::max(rate, term->rate());
  return rate;
}

bool System::splits_power() const
{
  return std::any_of(vesicles.begin(), vesicles.end(),
    [](const Vesicle& vesicle)
    { return vesicle.viscosity_ratio != 1 || vesicle.surface_viscosity != 0; });
}

bool System::only_relaxes() const
{
  return !flow && !repulsion &&
    std::all_of(vesicles.begin(), vesicles.end(),
      [](const Vesicle& vesicle)
      {
        return vesicle.conserved && vesicle.has_energy() &&
          std::none_of(vesicle.terms.begin(), vesicle.terms.end(),
            [](const auto& term) { return term->external(); });
      });
}

}
