#pragma once
// The flow far away, as if there were no vesicle.

#include "solver/scene/Scene.h"

namespace vesicle
{

/// u∞ at the points, in the units of flow and points: N by 3.
Points ambient_velocity(const Scene::Flow& flow, const Points& points);

/// The flow in dimensionless form: lengths divided by `length`, velocities by `velocity`.
Scene::Flow dimensionless(const Scene::Flow& flow, double length, double velocity);

/// The rate that the flow imposes on a vesicle of radius r0 = 1 (0 for a uniform flow).
double flow_rate(const Scene::Flow& flow);

}
