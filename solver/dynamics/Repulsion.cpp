#include "solver/dynamics/Repulsion.h"

#include "solver/Errors.h"

#include <fmt/format.h>

namespace vesicle
{

namespace
{

void require_apart(const Proximity::NearVertex& near)
{
  if (!(near.place.distance > 0))
    throw NumericalError(to_text(Gap{ near.place.distance, { near.vesicle, near.other },
      { near.place.position, near.place.position } }));
}

}

double Repulsion::energy(const Proximity& proximity) const
{
  double sum = 0;
  for (const Proximity::NearVertex& near : proximity.near())
  {
    require_apart(near);
    const double excess = range / near.place.distance - 1;
    sum +=
      strength * excess * excess * proximity.side(near.vesicle).surface->vertex_area[near.vertex];
  }
  return sum;
}

// Of the distance |x − y|, y the nearest point: it follows x along the normal and y against it; that y
// moves along the surface changes nothing.
std::vector<Eigen::VectorXd> Repulsion::gradients(const Proximity& proximity) const
{
  const std::size_t count = proximity.sides();
  std::vector<Eigen::VectorXd> gradients, at_vertices, densities;
  for (std::size_t v = 0; v < count; ++v)
  {
    const Eigen::Index n = proximity.side(v).surface->vertices.rows();
    gradients.emplace_back(Eigen::VectorXd::Zero(3 * n));
    at_vertices.emplace_back(Eigen::VectorXd::Zero(3 * n));
    densities.emplace_back(Eigen::VectorXd::Zero(n));
  }
  for (const Proximity::NearVertex& near : proximity.near())
  {
    require_apart(near);
    const Surface& own = *proximity.side(near.vesicle).surface;
    const double d = near.place.distance, excess = range / d - 1;
    const Vector3 x = own.vertices.row(near.vertex).transpose();
    const Vector3 pull = -2 * strength * excess * range / (d * d) * own.vertex_area[near.vertex] *
      (x - near.place.position) / d;
    densities[near.vesicle][near.vertex] += strength * excess * excess;
    at_vertices[near.vesicle].segment<3>(3 * near.vertex) += pull;
    const PanelBasis& basis = proximity.side(near.other).rules->panels();
    const Eigen::VectorXd share = basis.values(near.place.panel, near.place.u, near.place.v);
    const std::span<const int> nodes = basis.nodes(basis.element(near.place.panel));
    for (std::size_t k = 0; k < nodes.size(); ++k)
      gradients[near.other].segment<3>(3 * nodes[k]) -= share[static_cast<Eigen::Index>(k)] * pull;
  }
  for (std::size_t v = 0; v < count; ++v)
  {
    const Surface& surface = *proximity.side(v).surface;
    gradients[v] += surface.area_rate.transpose() * densities[v];
    gradients[v] += surface.collocation().to_vertices_adjoint(at_vertices[v]);
  }
  return gradients;
}

}
