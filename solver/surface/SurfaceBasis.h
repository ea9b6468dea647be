#pragma once
// What surface the points of a mesh stand for.

namespace vesicle
{

/// The points are on the surface in both. The numbers are those of the field data Surface_Basis.
enum class SurfaceBasis
{
  linear = 0, ///< the flat triangles
  loop = 1    ///< Loop's limit surface through the points
};

}
