#include "tests/benchmarks/InstructionSet.h"

#include <immintrin.h>

namespace vesicle::benchmarks
{
namespace
{

using Doubles = double __attribute__((vector_size(32)));
using Floats = float __attribute__((vector_size(32)));
using Integers = int __attribute__((vector_size(32)));
constexpr int side_by_side = 2;

// The seed, of single precision, is good for 3·2⁻¹³; the series to e⁴ leaves 63/256 e⁵.
void inverse_root(Doubles& y, const Doubles& s)
{
  y = (Doubles)_mm256_cvtps_pd(_mm_rsqrt_ps(_mm256_cvtpd_ps((__m256d)s)));
  const Doubles e = 1 - s * y * y;
  y += y * e * (1. / 2 + e * (3. / 8 + e * (5. / 16 + e * (35. / 128))));
}
void inverse_root(Floats& y, const Floats& s)
{
  y = (Floats)_mm256_rsqrt_ps((__m256)s);
  y *= 1.5f - 0.5f * y * (s * y);
}

}
}

#include "tests/benchmarks/HandWritten.inl.h"

vesicle::benchmarks::InstructionSet vesicle::benchmarks::avx2()
{
  return { "AVX2", hand_written<Doubles, double>(), hand_written<Floats, float>(), avx2_loops() };
}
