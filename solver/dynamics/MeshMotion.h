#pragma once
// How the nodes move. Only their normal velocity is physics; along the surface a fluid membrane
// leaves them free.

#include "solver/mesh/Connectivity.h"
#include "solver/mesh/TriangleMesh.h"
#include "solver/dynamics/TangentialMotion.h"
#include "solver/dynamics/VesicleLoads.h"

namespace vesicle
{

/// Node velocity w = ρ + n n·(u − ρ) + κ P_t r: ρ the shape's rigid motion (RigidMotion.h), r 3/2 of
/// the way to the wanted edge lengths (SizingLaw.h). Nodes follow the vesicle, not the lipids, and
/// gather where it bends. κ = 0.2 s + 3 max|u_t|, s the scene's rate. N by 3.
Points equidistributing_velocity(const Surface& surface, const AdjacencyList& neighbours,
  const Points& velocity, double scene_rate);

/// The motion along a smooth surface, implicit over τ. `loads`: of nodes that move along the normals.
TangentialMotion sliding_motion(const VesicleLoads& loads, double tau);
/// The same on a smooth surface, where the motion along the surface costs no energy, area or volume,
/// and goes down the energy that the mesh itself has. `loads`: of nodes that move along the normals;
/// `sliding`: theirs. `reference`: node velocities, or without rows.
Points sliding_velocity(const VesicleLoads& loads, const TangentialMotion& sliding,
  const AdjacencyList& neighbours, const Points& velocity, double scene_rate,
  const Points& reference);

/// κ of the above; a step dt with κ dt > 1/2 would overshoot.
double relaxation_rate(const Surface& surface, const Points& velocity, double scene_rate);

/// Largest |u_t|: the fluid's speed along the surface, seen from the centroid.
double tangential_speed(const Surface& surface, const Points& velocity);

}
