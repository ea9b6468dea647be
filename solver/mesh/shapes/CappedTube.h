#pragma once
// Triangulations of the sphere with twelve vertices of valence five and all others of valence six,
// the fewest irregular ones that can be, for slender and flat surfaces: a hexagonal lattice rolled
// up to a tube with two caps, as in a carbon nanotube or the head of a phage. D. L. D. Caspar,
// A. Klug, Cold Spring Harb. Symp. Quant. Biol. 27 (1962) 1; M. F. Moody, J. Mol. Biol. 293 (1999)
// 401 for the elongated ones.

#include "solver/mesh/shapes/SphereMesh.h"

#include <vector>

namespace vesicle
{

/// A cap is `fold` equilateral faces around a pole, their sides the lattice vector (h, k) in a
/// basis of two unit vectors at 60°, T = h² + hk + k² triangles each. The tube is 2 · fold faces of
/// Q triangles each. T = Q with a fold of 5 is the icosahedron.
struct CappedTube
{
  int fold; ///< 5 or 6; with 5 the poles are of valence five, with 6 the twelve corners of the caps
  int h, k;
  int Q; ///< positive, a multiple of gcd(h, k)

  int T() const { return h * h + h * k + k * k; }
  int triangles() const { return 2 * fold * (T() + Q); }
};

/// All with exactly that number of triangles: none unless it is a multiple of 10 or 12. Of two that
/// mirror each other, one.
std::vector<CappedTube> capped_tubes(int triangles);

/// The axis is z, and a half turn about y maps the mesh onto itself; rows of triangles have about
/// equal steps in latitude. `symmetries` is left empty.
SphereMesh capped_tube_mesh(const CappedTube& shape);

}
