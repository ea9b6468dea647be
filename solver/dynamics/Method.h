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

/// How the single layer of a smooth surface is applied.
enum class LayerMethod
{
  automatic, ///< the fastest: direct, and tree where there are many pairs
  dense,     ///< by its matrix
  direct,    ///< by sums over all pairs of points and vertices
  tree       ///< by sums over pairs of clusters of them
};

/// In what the linear solves add up far fields.
enum class LayerPrecision
{
  mixed, ///< single precision where that doesn't change the answer
  full   ///< double throughout
};

struct LayerSettings
{
  LayerMethod method = LayerMethod::automatic;
  LayerPrecision precision = LayerPrecision::mixed;
  double tree_tolerance = 1e-7; ///< relative error of the velocity
};

}
