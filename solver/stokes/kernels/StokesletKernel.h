#pragma once
// The inner loops of the single and the double layer. Compiled for several instruction sets
// (StokesletLoops.h); the widest that the processor has is chosen at run time.

#include <array>
#include <cstdint>
#include <numbers>
#include <type_traits>

namespace vesicle
{

/// Targets are taken in groups, one a lane: then scattering a source point to the nodes it feels is
/// a handful of vector operations, whatever the basis.
inline constexpr int stokeslet_lanes = 8;
/// Numbers that each node accumulates for each lane.
inline constexpr int stokeslet_components = 6;
/// 1/8π of the Stokeslet, μ = 1.
inline constexpr double kernel_factor = 0.125 * std::numbers::inv_pi;
/// 3/4π of the double layer's kernel X X (X·n)/r⁵, over 1/8π.
inline constexpr double double_layer_factor = 6;

/// Source points: the rows of a basis table at a shape.
struct StokesletSources
{
  const double *x, *y, *z, *weight; ///< of every row; weight contains dS/8πμ
  const int* element;               ///< of every row; rows of one element have the same nodes
  const int *start, *node;          ///< the rows' entries in the basis table
  const double* value;
};

/// For every entry (row, node k, N_k) of rows [begin, end), the components xx, xy, xz, yy, yz, zz
/// of weight · N_k · G are added to sum[(6 place[k] + component) · lanes + lane]. `targets` holds x,
/// y, z of the lanes (3 · lanes); `mask` (lanes) multiplies the weight.
void add_stokeslets(const StokesletSources& sources, int begin, int end, const double* targets,
  const double* mask, const int* place, double* sum);

/// Source points of the double layer.
struct StressletSources : StokesletSources
{
  const double* normal; ///< of every row: n, 3 numbers, one component after the other
  int rows;
};

/// As add_stokeslets, of weight · N_k · X Xᵀ (X·n)/r⁵, symmetric as G is.
void add_stresslets(const StressletSources& sources, int begin, int end, const double* targets,
  const double* mask, const int* place, double* sum);

/// What add_stokeslets or add_stresslets has made, at places 0 to nodes − 1, times their vectors (3 a node): the
/// velocities of the lanes, x, y, z (3 · lanes).
void multiply_stokeslets(const double* sum, int nodes, const double* vectors, double* velocities);

/// Points of a panel: its coordinates, and weights of du dv. `count` is a multiple of
/// stokeslet_lanes; a weight of 0 fills up.
struct PanelPoints
{
  const double *u, *v, *weight;
  int count;
};
/// A panel's position: coefficients of the monomials (PanelPolynomials.h) of degree 1 or 4, x, y, z
/// of each, `stride` numbers apart.
struct PanelShape
{
  const double* coefficients;
  int degree, stride;
};

/// Fields of points, X from the target to the source. An image is what a wall z = 0 that sticks adds to a
/// source's field; its position and strength are the mirrored source's (WallImage.h).
enum class PointKind
{
  force,          ///< of a force f: G f
  stresslet,      ///< of a symmetric tensor s: X (X·s X)/r⁵
  force_image,    ///< of f
  stresslet_image ///< of s
};
constexpr int components_of(PointKind kind)
{
  return kind == PointKind::force || kind == PointKind::force_image ? 3 : 6;
}
constexpr bool is_image(PointKind kind)
{
  return kind == PointKind::force_image || kind == PointKind::stresslet_image;
}

inline constexpr int point_kinds = 4;

/// Numbers of a kernel's block, 3 by 3: xx, xy, xz, yy, yz, zz; an image's isn't symmetric: its rows, one
/// after the other.
inline constexpr int image_components = 9;
constexpr int block_components(PointKind kind)
{
  return is_image(kind) ? image_components : stokeslet_components;
}

/// Σ weight · m_t · kernel dS/8πμ over the points, of every monomial m_t of the panel, is added to
/// sum[block_components t + component]; X from the target (x, y, z) to the point. The kernels are G and
/// X Xᵀ (X·n)/r⁵; of an image the panel is a mirrored one, whose normal a_u × a_v points inward.
void add_moments(PointKind kind, const PanelPoints& points, const PanelShape& panel,
  const double* target, double* sum);

/// Source points with a known force.
struct ForceSources : StokesletSources
{
  const double* force;  ///< of every row: f, 3 numbers, one component after the other
  const double* normal; ///< of every row, stored like f
  int rows;
};

/// Rows [begin, end) are added up: Σ weight G f (3 components) and Σ weight X·n/r³, X from the
/// target to the source, are added to sum[component · lanes + lane].
void add_velocities(const ForceSources& sources, int begin, int end, const double* targets,
  const double* mask, double* sum);

/// How sums in `Real` take positions. Single precision counts them on a grid (PointGrid.h): differences of
/// whole numbers are exact, where those of rounded numbers would lose what neighbours differ by.
template<class Real>
using Coordinate = std::conditional_t<std::is_same_v<Real, double>, double, std::int32_t>;

/// What acts at points, one array a component: x, y, z, or xx, xy, xz, yy, yz, zz. Of single precision no
/// number is above 1.
template<class Real, PointKind kind>
struct PointSources
{
  std::array<const Coordinate<Real>*, 3> position;
  std::array<const Real*, components_of(kind)> strength;
  int count;
};
template<class Real>
using PointForces = PointSources<Real, PointKind::force>;

/// Targets of a sum over points.
inline constexpr int sum_lanes = 16;

/// The sources' fields at the targets x, y, z of sum_lanes each are added to `velocities`, which
/// lie as they do. A target must not be a source. Single precision leaves an error of some 3e-7 of
/// the velocity: so many sources as its digits are enough for are added up in it, and these sums in double.
template<class Real, PointKind kind>
void add_points(
  const PointSources<Real, kind>& sources, const Coordinate<Real>* targets, double* velocities);

/// Σ a_i b_i.
double dot(const double* a, const double* b, long n);

}
