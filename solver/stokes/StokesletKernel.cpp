#include "solver/stokes/StokesletKernel.h"

#include "solver/Multiversion.h"

#include <cstring>

namespace vesicle
{

namespace
{

using Lanes = double __attribute__((vector_size(8 * stokeslet_lanes)));
using LaneBits = long long __attribute__((vector_size(8 * stokeslet_lanes)));

struct Targets
{
  Lanes x, y, z, mask;
};

VESICLE_INLINE void load(Lanes& lanes, const double* from)
{
  std::memcpy(&lanes, from, sizeof lanes);
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
  // 1/√r² from a seed by its exponent (3% off); each Newton step squares the error, four reach
  // double precision. Vector square roots and divisions are slower and don't vectorise portably.
  LaneBits bits;
  std::memcpy(&bits, &r2, sizeof bits);
  bits = 0x5fe6eb50c7b537a9LL - (bits >> 1);
  Lanes inverse;
  std::memcpy(&inverse, &bits, sizeof inverse);
  const Lanes half = 0.5 * r2;
  inverse *= 1.5 - half * inverse * inverse;
  inverse *= 1.5 - half * inverse * inverse;
  inverse *= 1.5 - half * inverse * inverse;
  inverse *= 1.5 - half * inverse * inverse;
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

VESICLE_MULTIVERSION
void add_stokeslets(const StokesletSources& s, int begin, int end, const double* targets,
  const double* mask, double* sum)
{
  Targets t;
  load(t, targets, mask);
  for (int q = begin, last; q < end; q = last)
  {
    last = group_end(s, q, end);
    const int rows = last - q, width = s.start[q + 1] - s.start[q];
    Lanes g[group_size][6];
    for (int r = 0; r < rows; ++r)
    {
      Pair p;
      evaluate(p, s, q + r, t);
      const Lanes hx = p.over_r3 * p.dx, hy = p.over_r3 * p.dy, hz = p.over_r3 * p.dz;
      g[r][0] = p.over_r + hx * p.dx;
      g[r][1] = hx * p.dy;
      g[r][2] = hx * p.dz;
      g[r][3] = p.over_r + hy * p.dy;
      g[r][4] = hy * p.dz;
      g[r][5] = p.over_r + hz * p.dz;
    }
    const double* value = s.value + s.start[q];
    for (int k = 0; k < width; ++k)
    {
      double* entry = entry_of(sum, s.node[s.start[q] + k]);
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

VESICLE_MULTIVERSION
void multiply_stokeslets(const double* sum, int nodes, const double* vectors, double* velocities)
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

VESICLE_MULTIVERSION
void add_velocities(
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

VESICLE_MULTIVERSION
double dot(const double* a, const double* b, long n)
{
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (long i = 0; i < n; ++i)
    sum += a[i] * b[i];
  return sum;
}

}
