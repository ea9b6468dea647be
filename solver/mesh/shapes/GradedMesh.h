#pragma once
// Meshes of smooth surfaces whose triangles are small where the surface is bent.

#include "solver/mesh/shapes/SphereMesh.h"

#include <functional>

namespace vesicle
{

/// The relative error of what a mesh is to hold: of the bending energy of Loop's surface, say.
using MeshError = std::function<double(const SphereMesh& mesh)>;

/// A mesh on `surface` whose edges follow the sizing law (SizingLaw.h), with twelve vertices of five
/// neighbours and all others of six, and with as many triangles as uniform_mesh() has. Of several
/// triangulations and states on their way the one is taken whose error is least; of errors that don't
/// differ, the one with the better angles.
SphereMesh graded_mesh(const SphericalParametrisation& surface, int triangles, Symmetry symmetry,
  const MeshError& error);

}
