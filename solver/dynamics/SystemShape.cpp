#include "solver/dynamics/SystemShape.h"

#include "solver/ParallelFor.h"

namespace vesicle
{

namespace
{

void add(std::optional<SparseMatrix>& sum, SparseMatrix&& part)
{
  if (!sum)
    sum = std::move(part);
  else
    *sum += part;
}

}

VesicleShape::VesicleShape(const Vesicle& v, std::unique_ptr<const Surface> at, double rate,
  const Eigen::VectorXd& from_others)
  : vesicle(&v), surface(std::move(at))
{
  if (v.incompressibility)
    constraint = std::make_shared<const ConstraintRows>(v.incompressibility->rows(*surface));
  if (v.space->smooth())
    add_loads(rate, from_others);
  else
    add_flat_forces(from_others);
}

void VesicleShape::add_flat_forces(const Eigen::VectorXd& from_others)
{
  lumped = std::make_unique<LumpedForces>(*surface, vesicle->incompressibility.get());
  NodalForce stiff;
  for (const auto& term : vesicle->terms)
  {
    TermForce force = term->force(*surface);
    (term->stiff() ? stiff : other_force) += force.density;
    forces.push_back(std::move(force.density));
    if (force.linearisation)
      add(linearisation, std::move(*force.linearisation));
  }
  stiff_force = std::move(stiff.normal);
  if (from_others.size() > 0)
  {
    force_from_others.vector =
      -scaled_rows(rows_of_three(from_others), surface->vertex_area.cwiseInverse());
    other_force += force_from_others;
  }
}

void VesicleShape::add_loads(double rate, const Eigen::VectorXd& from_others)
{
  loads = std::make_unique<VesicleLoads>(*vesicle, *surface, constraint, rate, from_others);
  NodalForce stiff;
  for (std::size_t t = 0; t < vesicle->terms.size(); ++t)
  {
    forces.push_back({ {}, loads->density(loads->loads()[t]) });
    (vesicle->terms[t]->stiff() ? stiff : other_force) += forces.back();
  }
  stiff_force = std::move(stiff.vector);
  if (from_others.size() > 0)
  {
    force_from_others.vector = loads->density(loads->load_from_others());
    other_force += force_from_others;
  }
}

NodalForce VesicleShape::force() const
{
  NodalForce sum = loads ? NodalForce{ {}, stiff_force } : NodalForce{ stiff_force, {} };
  return sum += other_force;
}

Mobility::Columns VesicleShape::columns() const
{
  return { stiff_force.size() > 0 || other_force.normal.size() > 0, constraint != nullptr,
    other_force.vector };
}

SystemShape::SystemShape(const System& system, const std::vector<Points>& at, double now)
  : points(at), time(now), first{ 0 }
{
  const std::size_t count = system.vesicles.size();
  std::vector<std::unique_ptr<const Surface>> surfaces(count);
  parallel_for(count,
    [&](std::size_t v)
    { surfaces[v] = std::make_unique<const Surface>(*system.vesicles[v].space, points[v]); });
  std::vector<Eigen::VectorXd> from_others(count);
  if (system.repulsion && count > 1)
  {
    std::vector<Proximity::Side> all;
    for (std::size_t v = 0; v < count; ++v)
      all.push_back({ system.vesicles[v].layer.get(), surfaces[v].get() });
    from_others = system.repulsion->gradients(Proximity(std::move(all), system.repulsion->range));
  }
  std::vector<std::optional<VesicleShape>> made(count);
  parallel_for(count,
    [&](std::size_t v) {
      made[v].emplace(system.vesicles[v], std::move(surfaces[v]), system.rate(), from_others[v]);
    });
  for (std::size_t v = 0; v < count; ++v)
  {
    vesicles.push_back(std::move(*made[v]));
    first.push_back(first.back() + points[v].rows());
  }
  imposed = Eigen::VectorXd::Zero(3 * vertices());
  if (const auto flow = flow_at(system.flow, time))
    for (std::size_t i = 0; i < vesicles.size(); ++i)
      imposed.segment(3 * first[i], 3 * points[i].rows()) = flat(flow->velocities(points[i]));
}

std::vector<Proximity::Side> sides(const SystemShape& shape)
{
  std::vector<Proximity::Side> sides;
  for (const VesicleShape& v : shape.vesicles)
    sides.push_back({ v.vesicle->layer.get(), v.surface.get() });
  return sides;
}

std::vector<LayerSurface> layer_surfaces(const SystemShape& shape)
{
  std::vector<LayerSurface> surfaces;
  for (const VesicleShape& v : shape.vesicles)
    surfaces.push_back({ v.vesicle->layer.get(), v.surface->vertices, v.surface->control });
  return surfaces;
}

std::vector<Mobility> mobilities(const SystemShape& shape)
{
  const StokesOperator layer(layer_surfaces(shape));
  std::vector<Mobility> result;
  for (int i = 0; i < static_cast<int>(shape.vesicles.size()); ++i)
  {
    const Mobility::Columns columns = shape.vesicles[i].columns();
    result.push_back(columns.any() ? shape.vesicles[i].lumped->mobility(layer, i, columns)
                                   : Mobility{ DenseMatrix(3 * shape.vertices(), 0) });
  }
  return result;
}

}
