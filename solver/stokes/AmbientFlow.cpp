#include "solver/stokes/AmbientFlow.h"

#include <cmath>

namespace vesicle
{

namespace
{

Vector3 velocity_at(const Scene::Flow& flow, const Vector3& x)
{
  switch (flow.kind)
  {
    case Scene::Flow::Kind::uniform:
      return flow.velocity;
    case Scene::Flow::Kind::shear:
      return { flow.rate * x.z(), 0, 0 };
    case Scene::Flow::Kind::planar_extension:
      return { flow.rate * x.x(), 0, -flow.rate * x.z() };
    case Scene::Flow::Kind::axisymmetric_extension:
      return { -flow.rate * x.x() / 2, -flow.rate * x.y() / 2, flow.rate * x.z() };
    case Scene::Flow::Kind::poiseuille:
    {
      const Vector3 from_axis = (x - flow.center).cross(flow.axis.normalized());
      return flow.speed * (1 - from_axis.squaredNorm() / (flow.radius * flow.radius)) *
        flow.axis.normalized();
    }
  }
  return Vector3::Zero();
}

}

Points ambient_velocity(const Scene::Flow& flow, const Points& points)
{
  Points u(points.rows(), 3);
  for (int i = 0; i < points.rows(); ++i)
    u.row(i) = velocity_at(flow, points.row(i).transpose()).transpose();
  return u;
}

Scene::Flow dimensionless(const Scene::Flow& flow, double length, double velocity)
{
  Scene::Flow f = flow;
  f.rate *= length / velocity;
  f.velocity /= velocity;
  f.speed /= velocity;
  f.radius /= length;
  f.center /= length;
  return f;
}

double flow_rate(const Scene::Flow& flow)
{
  switch (flow.kind)
  {
    case Scene::Flow::Kind::uniform:
      return 0;
    case Scene::Flow::Kind::poiseuille: // shear rate one r0 off the axis
      return 2 * std::abs(flow.speed) / (flow.radius * flow.radius);
    default:
      return std::abs(flow.rate);
  }
}

}
