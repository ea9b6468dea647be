#pragma once
// The inner loops, compiled for several instruction sets and chosen at run time. Hidden: where a
// program and a shared library both hold the solver each must choose its own, since the choice is
// made while they are being loaded.

#include <numbers>

namespace vesicle
{

/// Targets are taken in groups, one a lane: then scattering a source point to the nodes it feels is
/// a handful of vector operations, whatever the basis.
inline constexpr int stokeslet_lanes = 8;
/// Numbers that each node accumulates for each lane.
inline constexpr int stokeslet_components = 6;
/// 1/8π of the Stokeslet, μ = 1.
inline constexpr double kernel_factor = 0.125 * std::numbers::inv_pi;

/// Source points: the rows of a basis table at a shape.
struct StokesletSources
{
  const double *x, *y, *z, *weight; ///< of every row; weight contains dS/8πμ
  const int* element;               ///< of every row; rows of one element have the same nodes
  const int *start, *node;          ///< the rows' entries in the basis table
  const double* value;
};

/// For every entry (row, node k, N_k) of rows [begin, end), the components xx, xy, xz, yy, yz, zz
/// of weight · N_k · G are added to sum[(6 k + component) · lanes + lane]. `targets` holds x, y, z
/// of the lanes (3 · lanes); `mask` (lanes) multiplies the weight.
[[gnu::visibility("hidden")]] void add_stokeslets(const StokesletSources& sources, int begin,
  int end, const double* targets, const double* mask, double* sum);

/// What add_stokeslets has made, for all nodes, times their vectors (3 a node): the velocities of the
/// lanes, x, y, z (3 · lanes).
[[gnu::visibility("hidden")]] void multiply_stokeslets(
  const double* sum, int nodes, const double* vectors, double* velocities);

/// Source points with a known force.
struct ForceSources : StokesletSources
{
  const double* force;  ///< of every row: f, 3 numbers, one component after the other
  const double* normal; ///< of every row, stored like f
  int rows;
};

/// Rows [begin, end) are added up: Σ weight G f (3 components) and Σ weight X·n/r³, X from the
/// target to the source, are added to sum[component · lanes + lane].
[[gnu::visibility("hidden")]] void add_velocities(const ForceSources& sources, int begin, int end,
  const double* targets, const double* mask, double* sum);

/// Σ a_i b_i.
[[gnu::visibility("hidden")]] double dot(const double* a, const double* b, long n);

}
