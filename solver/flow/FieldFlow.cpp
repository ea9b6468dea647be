#include "solver/flow/FieldFlow.h"

#include "solver/Errors.h"

#include <algorithm>
#include <cmath>

namespace vesicle
{

const FlowKind& FieldFlow::description()
{
  static const FlowKind kind{ "field", "", "", "velocity field", "u of a VTK file",
    { flow_parameter("file", Dimension::file, &FieldFlow::file,
      "points with vectors: .vti .vtr .vts .vtu .vtk, or a .pvd or .series of them, in the scene's "
      "units") },
    make_flow<FieldFlow> };
  return kind;
}

const VelocityField& FieldFlow::given() const
{
  if (!field)
    throw InputError(file +
      ": a velocity field that hasn't been read; run it by vtkVesicleStepper "
      "or the command");
  return *field;
}

Points FieldFlow::velocities(const Points& points) const
{
  return given().velocities(points * length_unit, time * time_unit()) * (strength / velocity_unit);
}

Vector3 FieldFlow::velocity_at(const Vector3& x) const
{
  Points point(1, 3);
  point.row(0) = x.transpose();
  return velocities(point).row(0).transpose();
}

double FieldFlow::imposed_rate() const
{
  return std::abs(strength) * given().largest_rate() * time_unit();
}

std::shared_ptr<const ImposedFlow> FieldFlow::dimensionless(double length, double velocity) const
{
  auto scaled = std::make_shared<FieldFlow>(*this);
  scaled->length_unit *= length;
  scaled->velocity_unit *= velocity;
  scaled->time /= length / velocity;
  return scaled;
}

std::shared_ptr<const ImposedFlow> FieldFlow::times(double factor) const
{
  auto scaled = std::make_shared<FieldFlow>(*this);
  scaled->strength *= factor;
  return scaled;
}

std::shared_ptr<const ImposedFlow> FieldFlow::at(double then) const
{
  if (!field || field->times().size() < 2)
    return {};
  auto moment = std::make_shared<FieldFlow>(*this);
  moment->time = then;
  return moment;
}

std::optional<double> FieldFlow::next_corner(double now) const
{
  if (!field || field->times().size() < 2)
    return {};
  const auto& times = field->times();
  const double given_now = now * time_unit();
  // A time that has been hit may differ by rounding.
  const auto next = std::find_if(times.begin(), times.end(),
    [&](double t) { return t > given_now + 1e-10 * std::abs(given_now); });
  return next == times.end() ? std::nullopt : std::optional(*next / time_unit());
}

bool FieldFlow::settled(double now) const
{
  return !next_corner(now);
}

}
