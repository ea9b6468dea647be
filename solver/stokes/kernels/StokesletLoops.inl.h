// The loops of StokesletKernel.h, for the instruction set that the file which includes this is compiled
// for, as `loops`. Nothing that isn't always inlined or in this file may be called: the linker could
// take it for the others, too.

#include "solver/Multiversion.h"
#include "solver/stokes/kernels/StokesletLoops.h"

#include <cstring>
#include <limits>
#include <type_traits>
#ifdef __AVX2__
#include <immintrin.h>
#endif

namespace vesicle
{
namespace
{

// One register: gcc handles wider vectors badly.
#if defined(__AVX512F__)
constexpr int bytes = 64;
#elif defined(__AVX2__)
constexpr int bytes = 32;
#else
constexpr int bytes = 16;
#endif
using Doubles = double __attribute__((vector_size(bytes)));
using Floats = float __attribute__((vector_size(bytes)));
using Integers = std::int32_t __attribute__((vector_size(bytes)));
template<class Real>
using Wide = std::conditional_t<sizeof(Real) == sizeof(double), Doubles, Floats>;
template<class Real>
using WideCoordinate = std::conditional_t<sizeof(Real) == sizeof(double), Doubles, Integers>;

// y ← 1/√s from a y with s y² = 1 − e: the series to e³, which leaves 35/128 e⁴.
template<class Real, class Vector>
VESICLE_INLINE void improve(Vector& y, const Vector& s)
{
  constexpr Real a = 1. / 2, b = 3. / 8, c = 5. / 16;
  const Vector e = 1 - s * y * y;
  y += y * e * (a + e * (b + e * c));
}

// 1/√s to rounding, of positive numbers. Square roots and divisions are slower.
#if defined(__AVX512F__)
VESICLE_INLINE void inverse_root(Doubles& y, const Doubles& s)
{
  y = (Doubles)_mm512_maskz_rsqrt14_pd(0xff, (__m512d)s);
  improve<double>(y, s);
}
VESICLE_INLINE void inverse_root(Floats& y, const Floats& s)
{
  y = (Floats)_mm512_maskz_rsqrt14_ps(0xffff, (__m512)s);
  y += 0.5f * y * (1 - s * y * y);
}
#elif defined(__AVX2__)
// The processor's estimate is 4e-4 off; there is none of doubles beyond the range of floats, 1e±38.
VESICLE_INLINE void inverse_root(Doubles& y, const Doubles& s)
{
  y = (Doubles)_mm256_cvtps_pd(_mm_rsqrt_ps(_mm256_cvtpd_ps((__m256d)s)));
  improve<double>(y, s);
  y += 0.5 * y * (1 - s * y * y);
}
VESICLE_INLINE void inverse_root(Floats& y, const Floats& s)
{
  y = (Floats)_mm256_rsqrt_ps((__m256)s);
  y += 0.5f * y * (1 - s * y * y);
}
#else
// The seed by the exponent is 3% off, once improved 7e-6.
VESICLE_INLINE void inverse_root(Doubles& y, const Doubles& s)
{
  long long __attribute__((vector_size(bytes))) bits;
  std::memcpy(&bits, &s, sizeof bits);
  bits = 0x5fe6eb50c7b537a9LL - (bits >> 1);
  std::memcpy(&y, &bits, sizeof y);
  improve<double>(y, s);
  improve<double>(y, s);
}
VESICLE_INLINE void inverse_root(Floats& y, const Floats& s)
{
  int __attribute__((vector_size(bytes))) bits;
  std::memcpy(&bits, &s, sizeof bits);
  bits = 0x5f375a86 - (bits >> 1);
  std::memcpy(&y, &bits, sizeof y);
  improve<float>(y, s);
  y += 0.5f * y * (1 - s * y * y);
}
#endif

// stokeslet_lanes of numbers are taken in parts of `lanes`: what begins at the part's first lane.
using Lanes = Doubles;
constexpr int lanes = bytes / sizeof(double);

struct Targets
{
  Lanes x, y, z, mask;
};

VESICLE_INLINE void load(Lanes& to, const double* from)
{
  std::memcpy(&to, from, sizeof to);
}

VESICLE_INLINE void load(Targets& t, const double* targets, const double* mask)
{
  load(t.x, targets);
  load(t.y, targets + stokeslet_lanes);
  load(t.z, targets + 2 * stokeslet_lanes);
  load(t.mask, mask);
}

// X = y − x, weight/r and weight/r³ of one source point.
struct Pair
{
  Lanes dx, dy, dz, over_r, over_r3;
};

VESICLE_INLINE void evaluate(Pair& p, const StokesletSources& s, int q, const Targets& t)
{
  p.dx = s.x[q] - t.x;
  p.dy = s.y[q] - t.y;
  p.dz = s.z[q] - t.z;
  const Lanes r2 = p.dx * p.dx + p.dy * p.dy + p.dz * p.dz;
  Lanes inverse;
  inverse_root(inverse, r2);
  p.over_r = s.weight[q] * t.mask * inverse;
  p.over_r3 = p.over_r * inverse * inverse;
}

// weight G d for a vector d of the source point.
VESICLE_INLINE void apply(Lanes g[3], const Pair& p, double x, double y, double z)
{
  const Lanes along = p.over_r3 * (x * p.dx + y * p.dy + z * p.dz);
  g[0] = x * p.over_r + along * p.dx;
  g[1] = y * p.over_r + along * p.dy;
  g[2] = z * p.over_r + along * p.dz;
}

VESICLE_INLINE double* entry_of(double* sum, int node)
{
  return sum + static_cast<long>(node) * (stokeslet_components * stokeslet_lanes);
}

// Rows of one element feel the same nodes: up to this many are added to a node at once.
constexpr int group_size = 6;

VESICLE_INLINE int group_end(const StokesletSources& s, int q, int end)
{
  int last = q + 1;
  while (last < end && last < q + group_size && s.element[last] == s.element[q])
    ++last;
  return last;
}

// xx, xy, xz, yy, yz, zz of the kernel between a source point and the targets.
VESICLE_INLINE void components(Lanes g[6], const StokesletSources& s, int q, const Targets& t)
{
  Pair p;
  evaluate(p, s, q, t);
  const Lanes hx = p.over_r3 * p.dx, hy = p.over_r3 * p.dy, hz = p.over_r3 * p.dz;
  g[0] = p.over_r + hx * p.dx;
  g[1] = hx * p.dy;
  g[2] = hx * p.dz;
  g[3] = p.over_r + hy * p.dy;
  g[4] = hy * p.dz;
  g[5] = p.over_r + hz * p.dz;
}

VESICLE_INLINE void components(Lanes g[6], const StressletSources& s, int q, const Targets& t)
{
  const Lanes dx = s.x[q] - t.x, dy = s.y[q] - t.y, dz = s.z[q] - t.z;
  Lanes inverse;
  inverse_root(inverse, dx * dx + dy * dy + dz * dz);
  const int n = s.rows;
  const Lanes square = inverse * inverse,
              factor = s.weight[q] * t.mask * inverse * square * square *
    (s.normal[q] * dx + s.normal[q + n] * dy + s.normal[q + 2 * n] * dz);
  const Lanes hx = factor * dx, hy = factor * dy, hz = factor * dz;
  g[0] = hx * dx;
  g[1] = hx * dy;
  g[2] = hx * dz;
  g[3] = hy * dy;
  g[4] = hy * dz;
  g[5] = hz * dz;
}

template<class Sources>
VESICLE_INLINE void add_part_to_nodes(const Sources& s, int begin, int end, const double* targets,
  const double* mask, const int* place, double* sum)
{
  Targets t;
  load(t, targets, mask);
  for (int q = begin, last; q < end; q = last)
  {
    last = group_end(s, q, end);
    const int rows = last - q, width = s.start[q + 1] - s.start[q];
    Lanes g[group_size][6];
    for (int r = 0; r < rows; ++r)
      components(g[r], s, q + r, t);
    const double* value = s.value + s.start[q];
    for (int k = 0; k < width; ++k)
    {
      double* entry = entry_of(sum, place[s.node[s.start[q] + k]]);
      for (int c = 0; c < 6; ++c)
      {
        Lanes total;
        load(total, entry + c * stokeslet_lanes);
        for (int r = 0; r < rows; ++r)
          total += value[r * width + k] * g[r][c];
        std::memcpy(entry + c * stokeslet_lanes, &total, sizeof total);
      }
    }
  }
}

VESICLE_INLINE void multiply_part_of_stokeslets(
  const double* sum, int nodes, const double* vectors, double* velocities)
{
  Lanes x{}, y{}, z{};
  for (int k = 0; k < nodes; ++k, sum += stokeslet_components * stokeslet_lanes, vectors += 3)
  {
    Lanes g[6];
    for (int c = 0; c < 6; ++c)
      load(g[c], sum + c * stokeslet_lanes);
    x += g[0] * vectors[0] + g[1] * vectors[1] + g[2] * vectors[2];
    y += g[1] * vectors[0] + g[3] * vectors[1] + g[4] * vectors[2];
    z += g[2] * vectors[0] + g[4] * vectors[1] + g[5] * vectors[2];
  }
  std::memcpy(velocities, &x, sizeof x);
  std::memcpy(velocities + stokeslet_lanes, &y, sizeof y);
  std::memcpy(velocities + 2 * stokeslet_lanes, &z, sizeof z);
}

VESICLE_INLINE void add_part_of_velocities(
  const ForceSources& s, int begin, int end, const double* targets, const double* mask, double* sum)
{
  Targets t;
  load(t, targets, mask);
  Lanes total[4];
  for (int c = 0; c < 4; ++c)
    load(total[c], sum + c * stokeslet_lanes);
  const int n = s.rows;
  for (int q = begin; q < end; ++q)
  {
    Pair p;
    evaluate(p, s, q, t);
    Lanes g[3];
    apply(g, p, s.force[q], s.force[q + n], s.force[q + 2 * n]);
    for (int c = 0; c < 3; ++c)
      total[c] += g[c];
    total[3] +=
      p.over_r3 * (s.normal[q] * p.dx + s.normal[q + n] * p.dy + s.normal[q + 2 * n] * p.dz);
  }
  for (int c = 0; c < 4; ++c)
    std::memcpy(sum + c * stokeslet_lanes, &total[c], sizeof total[c]);
}

void add_stokeslets(const StokesletSources& s, int begin, int end, const double* targets,
  const double* mask, const int* place, double* sum)
{
  for (int i = 0; i < stokeslet_lanes; i += lanes)
    add_part_to_nodes(s, begin, end, targets + i, mask + i, place, sum + i);
}

void add_stresslets(const StressletSources& s, int begin, int end, const double* targets,
  const double* mask, const int* place, double* sum)
{
  for (int i = 0; i < stokeslet_lanes; i += lanes)
    add_part_to_nodes(s, begin, end, targets + i, mask + i, place, sum + i);
}

void multiply_stokeslets(const double* sum, int nodes, const double* vectors, double* velocities)
{
  for (int i = 0; i < stokeslet_lanes; i += lanes)
    multiply_part_of_stokeslets(sum + i, nodes, vectors, velocities + i);
}

void add_velocities(
  const ForceSources& s, int begin, int end, const double* targets, const double* mask, double* sum)
{
  for (int i = 0; i < stokeslet_lanes; i += lanes)
    add_part_of_velocities(s, begin, end, targets + i, mask + i, sum + i);
}

// A vector of a panel's points: their monomials, where they are and a_u × a_v.
template<int degree>
struct PanelPlaces
{
  static constexpr int terms = (degree + 1) * (degree + 2) / 2;
  Lanes monomial[terms], position[3], cross[3];
};

template<int degree>
VESICLE_INLINE void evaluate(
  PanelPlaces<degree>& p, const PanelShape& panel, const Lanes& u, const Lanes& v)
{
  Lanes power_u[degree + 1], power_v[degree + 1], a[3]{}, b[3]{};
  power_u[0] = power_v[0] = Lanes{} + 1;
  for (int i = 1; i <= degree; ++i)
  {
    power_u[i] = power_u[i - 1] * u;
    power_v[i] = power_v[i - 1] * v;
  }
  for (int k = 0; k < 3; ++k)
    p.position[k] = Lanes{};
  const double* c = panel.coefficients;
  int term = 0;
  for (int d = 0; d <= degree; ++d)
    for (int j = 0; j <= d; ++j, ++term, c += panel.stride)
    {
      const int i = d - j;
      p.monomial[term] = power_u[i] * power_v[j];
      const Lanes du = i > 0 ? i * power_u[i > 0 ? i - 1 : 0] * power_v[j] : Lanes{},
                  dv = j > 0 ? j * power_u[i] * power_v[j > 0 ? j - 1 : 0] : Lanes{};
      for (int k = 0; k < 3; ++k)
      {
        p.position[k] += c[k] * p.monomial[term];
        a[k] += c[k] * du;
        b[k] += c[k] * dv;
      }
    }
  for (int k = 0; k < 3; ++k)
    p.cross[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

// dS/(du dv).
template<int degree>
VESICLE_INLINE void area_element(Lanes& area, const PanelPlaces<degree>& p)
{
  const Lanes square = p.cross[0] * p.cross[0] + p.cross[1] * p.cross[1] + p.cross[2] * p.cross[2];
  Lanes inverse;
  inverse_root(inverse, square);
  area = square * inverse;
}

// weight · kernel dS/8πμ at points of a panel.
template<PointKind kind, int degree>
VESICLE_INLINE std::enable_if_t<!is_image(kind)> components(
  Lanes g[6], const PanelPlaces<degree>& p, const Lanes& weight, const double* target)
{
  const Lanes dx = p.position[0] - target[0], dy = p.position[1] - target[1],
              dz = p.position[2] - target[2];
  Lanes inverse;
  inverse_root(inverse, dx * dx + dy * dy + dz * dz);
  const Lanes square = inverse * inverse, share = kernel_factor * weight * inverse;
  Lanes over_r{}, along;
  if constexpr (kind == PointKind::stresslet)
    along = share * square * square * (p.cross[0] * dx + p.cross[1] * dy + p.cross[2] * dz);
  else
  {
    Lanes area;
    area_element(area, p);
    over_r = share * area;
    along = over_r * square;
  }
  const Lanes hx = along * dx, hy = along * dy, hz = along * dz;
  g[0] = over_r + hx * dx;
  g[1] = hx * dy;
  g[2] = hx * dz;
  g[3] = over_r + hy * dy;
  g[4] = hy * dz;
  g[5] = over_r + hz * dz;
}

// Rows of the image's block in WallImage.h, of the force or of n uᵀ for u, times the weight.
template<PointKind kind, int degree>
VESICLE_INLINE std::enable_if_t<is_image(kind)> components(
  Lanes g[9], const PanelPlaces<degree>& p, const Lanes& weight, const double* target)
{
  const Lanes d[3] = { p.position[0] - target[0], p.position[1] - target[1],
    p.position[2] - target[2] };
  Lanes inverse;
  inverse_root(inverse, d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  const Lanes square = inverse * inverse, share = kernel_factor * weight * inverse,
              h = -p.position[2], z = Lanes{} + target[2];
  Lanes scale, unit, dd, d3, e3d, e33{};
  if constexpr (kind == PointKind::force_image)
  {
    Lanes area;
    area_element(area, p);
    scale = share * area;
    unit = -1 - 2 * z * h * square;
    dd = square * (6 * z * h * square - 1);
    d3 = -2 * z * square;
    e3d = -2 * h * square;
    e33 = Lanes{} + 2;
  }
  else
  {
    scale = share * square * square;
    const Lanes along = -(p.cross[0] * d[0] + p.cross[1] * d[1] + p.cross[2] * d[2]);
    unit = -2 * z * h * along;
    dd = along * (10 * z * h * square - 1);
    d3 = 2 * z;
    e3d = -2 * h * along;
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      Lanes entry = dd * d[i] * d[j];
      if (i == j)
        entry += unit;
      if (i == 2)
        entry += e3d * d[j];
      if constexpr (kind == PointKind::force_image)
      {
        if (j == 2)
          entry += d3 * d[i];
        if (i == 2 && j == 2)
          entry += e33;
      }
      else
        entry += d3 * (h * p.cross[i] * d[j] - z * d[i] * p.cross[j]);
      g[3 * i + j] = scale * entry;
    }
}

template<int degree, PointKind kind>
VESICLE_INLINE void add_moments_of_degree(
  const PanelPoints& points, const PanelShape& panel, const double* target, double* sum)
{
  constexpr int terms = PanelPlaces<degree>::terms, size = block_components(kind);
  Lanes total[terms][size];
  std::memset(&total, 0, sizeof total);
  for (int q = 0; q < points.count; q += lanes)
  {
    Lanes u, v, weight, g[size];
    load(u, points.u + q);
    load(v, points.v + q);
    load(weight, points.weight + q);
    PanelPlaces<degree> p;
    evaluate<degree>(p, panel, u, v);
    components<kind, degree>(g, p, weight, target);
    for (int t = 0; t < terms; ++t)
      for (int c = 0; c < size; ++c)
        total[t][c] += p.monomial[t] * g[c];
  }
  for (int t = 0; t < terms; ++t)
    for (int c = 0; c < size; ++c)
      for (int i = 0; i < lanes; ++i)
        sum[size * t + c] += total[t][c][i];
}

template<PointKind kind>
void add_moments(
  const PanelPoints& points, const PanelShape& panel, const double* target, double* sum)
{
  if (panel.degree == 1)
    add_moments_of_degree<1, kind>(points, panel, target, sum);
  else
    add_moments_of_degree<4, kind>(points, panel, target, sum);
}

// Powers of 1/r are taken one by one: on the grid of single precision r⁻⁵ would be below its range.
template<class Real>
struct PointPair
{
  Wide<Real> dx, dy, dz, over_r;
};

template<class Real>
VESICLE_INLINE void add_velocity(
  Wide<Real> u[3], const PointForces<Real>& s, int q, const PointPair<Real>& p, const Wide<Real>&)
{
  const Real fx = s.strength[0][q], fy = s.strength[1][q], fz = s.strength[2][q];
  const Wide<Real> along = (fx * p.dx + fy * p.dy + fz * p.dz) * (p.over_r * p.over_r);
  u[0] += p.over_r * (fx + along * p.dx);
  u[1] += p.over_r * (fy + along * p.dy);
  u[2] += p.over_r * (fz + along * p.dz);
}

template<class Real>
VESICLE_INLINE void add_velocity(Wide<Real> u[3], const PointSources<Real, PointKind::stresslet>& s,
  int q, const PointPair<Real>& p, const Wide<Real>&)
{
  const auto& [dx, dy, dz, over_r] = p;
  const Real xx = s.strength[0][q], xy = s.strength[1][q], xz = s.strength[2][q],
             yy = s.strength[3][q], yz = s.strength[4][q], zz = s.strength[5][q];
  const Wide<Real> square = over_r * over_r,
                   along =
                     (dx * (xx * dx + xy * dy + xz * dz) + dy * (xy * dx + yy * dy + yz * dz) +
                       dz * (xz * dx + yz * dy + zz * dz)) *
    square * (over_r * square);
  u[0] += along * dx;
  u[1] += along * dy;
  u[2] += along * dz;
}

// The images: their source's z is −h.
template<class Real>
VESICLE_INLINE void add_velocity(Wide<Real> u[3],
  const PointSources<Real, PointKind::force_image>& s, int q, const PointPair<Real>& p,
  const Wide<Real>& z)
{
  const auto& [dx, dy, dz, over_r] = p;
  const Real fx = s.strength[0][q], fy = s.strength[1][q], fz = s.strength[2][q],
             h = -static_cast<Real>(s.position[2][q]);
  const Wide<Real> square = over_r * over_r, z2 = 2 * z, f = fx * dx + fy * dy + fz * dz,
                   hf = h * square * f, along = square * (z2 * (3 * hf - fz) - f),
                   unit = -1 - h * z2 * square;
  u[0] += over_r * (along * dx + fx * unit);
  u[1] += over_r * (along * dy + fy * unit);
  u[2] += over_r * (along * dz + fz * unit + 2 * (fz - hf));
}

template<class Real>
VESICLE_INLINE void add_velocity(Wide<Real> u[3],
  const PointSources<Real, PointKind::stresslet_image>& s, int q, const PointPair<Real>& p,
  const Wide<Real>& z)
{
  const auto& [dx, dy, dz, over_r] = p;
  const Real xx = s.strength[0][q], xy = s.strength[1][q], xz = s.strength[2][q],
             yy = s.strength[3][q], yz = s.strength[4][q], zz = s.strength[5][q],
             h = -static_cast<Real>(s.position[2][q]), trace = xx + yy + zz;
  const Wide<Real> square = over_r * over_r, sx = xx * dx + xy * dy + xz * dz,
                   sy = xy * dx + yy * dy + yz * dz, sz = xz * dx + yz * dy + zz * dz,
                   dsd = (dx * sx + dy * sy + dz * sz) * square,
                   along = 2 * z * square * (5 * h * dsd + trace * z) - dsd,
                   across = -4 * h * z * square, scale = over_r * square;
  u[0] += scale * (along * dx + across * sx);
  u[1] += scale * (along * dy + across * sy);
  u[2] += scale * (along * dz + across * sz - 2 * h * dsd);
}

// Sources that single precision has digits for: rounding their sum leaves 2e-7.
template<class Real>
constexpr int most_added_up = std::is_same_v<Real, double> ? std::numeric_limits<int>::max() : 128;

// Two vectors of targets side by side, so that one's arithmetic fills the other's waits.
template<class Real, PointKind kind>
VESICLE_INLINE void add_sources_at(const PointSources<Real, kind>& s, int begin, int end,
  const Coordinate<Real>* targets, double* velocities)
{
  constexpr int width = bytes / sizeof(Real), vectors = width < sum_lanes ? 2 : 1;
  WideCoordinate<Real> x[vectors][3];
  Wide<Real> z[vectors], u[vectors][3];
  for (int v = 0; v < vectors; ++v)
  {
    for (int c = 0; c < 3; ++c)
    {
      std::memcpy(&x[v][c], targets + c * sum_lanes + v * width, bytes);
      u[v][c] = Wide<Real>{};
    }
    z[v] = __builtin_convertvector(x[v][2], Wide<Real>);
  }
  for (int q = begin; q < end; ++q)
    for (int v = 0; v < vectors; ++v)
    {
      PointPair<Real> p;
      p.dx = __builtin_convertvector(s.position[0][q] - x[v][0], Wide<Real>);
      p.dy = __builtin_convertvector(s.position[1][q] - x[v][1], Wide<Real>);
      p.dz = __builtin_convertvector(s.position[2][q] - x[v][2], Wide<Real>);
      inverse_root(p.over_r, p.dx * p.dx + p.dy * p.dy + p.dz * p.dz);
      add_velocity<Real>(u[v], s, q, p, z[v]);
    }
  for (int v = 0; v < vectors; ++v)
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < width; ++i)
        velocities[c * sum_lanes + v * width + i] += u[v][c][i];
}

template<class Real, PointKind kind>
void add_sources(
  const PointSources<Real, kind>& s, const Coordinate<Real>* targets, double* velocities)
{
  constexpr int width = bytes / sizeof(Real), at_once = width < sum_lanes ? 2 * width : width;
  for (int q = 0, end; q < s.count; q = end)
  {
    end = s.count - q < most_added_up<Real> ? s.count : q + most_added_up<Real>;
    for (int i = 0; i < sum_lanes; i += at_once)
      add_sources_at(s, q, end, targets + i, velocities + i);
  }
}

double dot(const double* a, const double* b, long n)
{
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (long i = 0; i < n; ++i)
    sum += a[i] * b[i];
  return sum;
}

template<class Real>
constexpr PointLoops<Real> point_loops{ add_sources<Real, PointKind::force>,
  add_sources<Real, PointKind::stresslet>, add_sources<Real, PointKind::force_image>,
  add_sources<Real, PointKind::stresslet_image> };

constexpr StokesletLoops loops{ add_stokeslets, add_stresslets, multiply_stokeslets,
  { add_moments<PointKind::force>, add_moments<PointKind::stresslet>,
    add_moments<PointKind::force_image>, add_moments<PointKind::stresslet_image> },
  add_velocities, point_loops<double>, point_loops<float>, dot };

}
}
