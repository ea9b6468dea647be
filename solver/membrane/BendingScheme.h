#pragma once

namespace vesicle
{

/// Where the bending force comes from.
enum class BendingScheme
{
  cotan,      ///< cotangent formulas on flat triangles (HelfrichBending.h)
  fit,        ///< fitted quadrics: right on any mesh, but the gradient of no energy of the mesh
  variational ///< the energy's own gradient on the Loop surface (HelfrichBending.h)
};

}
