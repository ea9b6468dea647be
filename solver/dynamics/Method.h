#pragma once
// The choices that a user has in the method.

namespace vesicle
{

/// How loads, tension and projection are discretised on flat triangles.
enum class Scheme
{
  paper, ///< as printed (misprints corrected)
  robust ///< Galerkin loads, adjoint tension, volume row (docs/numerics.md)
};

enum class Integrator
{
  imex_midpoint, ///< second order in time
  imex_euler     ///< first order, paper (40)
};

}
