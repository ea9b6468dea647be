#pragma once
// The inner loops, compiled for several instruction sets and chosen at run time.

namespace vesicle
{

/// Targets are taken in groups, one a lane: then scattering a source point to the nodes it feels is
/// a handful of vector operations, whatever the basis.
inline constexpr int stokeslet_lanes = 8;

struct StokesletSources
{
  const double *x, *y, *z, *weight; ///< of every row; weight contains dS/8πμ
  const int *start, *node;          ///< the rows' entries in the basis table
  const double* value;
};

/// Adds rows [begin, end) to the accumulators of the targets: for every entry (row, node k, N_k)
/// the six components xx, xy, xz, yy, yz, zz of weight · N_k · G go to sum[(6 k + component) ·
/// lanes + lane]. `targets` holds x, y, z of the lanes (3 · lanes); `mask` (lanes) multiplies the
/// weight.
void add_stokeslets(const StokesletSources& sources, int begin, int end, const double* targets,
  const double* mask, double* sum);

/// Σ a_i b_i.
double dot(const double* a, const double* b, long n);

}
