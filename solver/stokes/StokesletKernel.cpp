#include "solver/stokes/StokesletKernel.h"

#include <cstring>

// The widest instruction set that the processor has is chosen when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
  !defined(__SANITIZE_ADDRESS__)
#define VESICLE_MULTIVERSION                                                                       \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define VESICLE_MULTIVERSION
#endif

namespace vesicle
{

namespace
{

using Lanes = double __attribute__((vector_size(8 * stokeslet_lanes)));
using LaneBits = long long __attribute__((vector_size(8 * stokeslet_lanes)));

}

VESICLE_MULTIVERSION
void add_stokeslets(const StokesletSources& s, int begin, int end, const double* targets,
  const double* mask, double* sum)
{
  Lanes target_x, target_y, target_z, lane_mask;
  std::memcpy(&target_x, targets, sizeof(Lanes));
  std::memcpy(&target_y, targets + stokeslet_lanes, sizeof(Lanes));
  std::memcpy(&target_z, targets + 2 * stokeslet_lanes, sizeof(Lanes));
  std::memcpy(&lane_mask, mask, sizeof(Lanes));
  for (int q = begin; q < end; ++q)
  {
    const Lanes dx = s.x[q] - target_x, dy = s.y[q] - target_y, dz = s.z[q] - target_z;
    const Lanes r2 = dx * dx + dy * dy + dz * dz;
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

    const Lanes over_r = s.weight[q] * lane_mask * inverse;
    const Lanes over_r3 = over_r * inverse * inverse;
    const Lanes hx = over_r3 * dx, hy = over_r3 * dy, hz = over_r3 * dz;
    const Lanes g[6] = { over_r + hx * dx, hx * dy, hx * dz, over_r + hy * dy, hy * dz,
      over_r + hz * dz };
    for (int k = s.start[q]; k < s.start[q + 1]; ++k)
    {
      double* entry = sum + static_cast<long>(s.node[k]) * (6 * stokeslet_lanes);
      for (int c = 0; c < 6; ++c)
      {
        Lanes total;
        std::memcpy(&total, entry + c * stokeslet_lanes, sizeof total);
        total += s.value[k] * g[c];
        std::memcpy(entry + c * stokeslet_lanes, &total, sizeof total);
      }
    }
  }
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
