#pragma once

namespace vesicle
{

/// How nodes follow the fluid (NodeMotion.h).
enum class NodeMotionKind
{
  normal, ///< Q u = P⁻¹[ρ + n n·(P u − ρ)] at the vertices, ρ the shape's rigid motion; along the
          ///< membrane they spread by its curvature
  material ///< Q = 1: with the lipids
};

}
