#include "solver/dynamics/SystemShape.h"

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

VesicleShape::VesicleShape(const Vesicle& v, const Points& points, double rate)
  : vesicle(&v), surface(std::make_unique<Surface>(*v.space, points))
{
  if (v.incompressibility)
    constraint = std::make_shared<const ConstraintRows>(v.incompressibility->rows(*surface));
  if (v.space->smooth())
    add_loads(rate);
  else
    add_flat_forces();
}

void VesicleShape::add_flat_forces()
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
}

void VesicleShape::add_loads(double rate)
{
  loads = std::make_unique<VesicleLoads>(*vesicle, *surface, constraint, rate);
  NodalForce stiff;
  for (std::size_t t = 0; t < vesicle->terms.size(); ++t)
  {
    forces.push_back({ {}, loads->density(loads->loads()[t]) });
    (vesicle->terms[t]->stiff() ? stiff : other_force) += forces.back();
  }
  stiff_force = std::move(stiff.vector);
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
  for (std::size_t i = 0; i < system.vesicles.size(); ++i)
  {
    vesicles.emplace_back(system.vesicles[i], points[i], system.rate());
    first.push_back(first.back() + points[i].rows());
  }
  imposed = Eigen::VectorXd::Zero(3 * vertices());
  if (const auto flow = flow_at(system.flow, time))
    for (std::size_t i = 0; i < vesicles.size(); ++i)
      imposed.segment(3 * first[i], 3 * points[i].rows()) = flat(flow->velocities(points[i]));
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
