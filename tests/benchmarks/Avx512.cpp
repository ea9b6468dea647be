#include "tests/benchmarks/InstructionSet.h"

#include <immintrin.h>

namespace vesicle::benchmarks
{
namespace
{

using Doubles = double __attribute__((vector_size(64)));
using Floats = float __attribute__((vector_size(64)));
using Integers = int __attribute__((vector_size(64)));
constexpr int side_by_side = 3;

// The seeds are good for 2⁻¹⁴; the series to e³ leaves 35/128 e⁴.
void inverse_root(Doubles& y, const Doubles& s)
{
  y = (Doubles)_mm512_maskz_rsqrt14_pd(0xff, (__m512d)s);
  const Doubles e = 1 - s * y * y;
  y += y * e * (1. / 2 + e * (3. / 8 + e * (5. / 16)));
}
void inverse_root(Floats& y, const Floats& s)
{
  y = (Floats)_mm512_maskz_rsqrt14_ps(0xffff, (__m512)s);
  y *= 1.5f - 0.5f * y * (s * y);
}

}
}

#include "tests/benchmarks/HandWritten.inl.h"

vesicle::benchmarks::InstructionSet vesicle::benchmarks::avx512()
{
  return { "AVX-512", hand_written<Doubles, double>(), hand_written<Floats, float>(),
    avx512_loops() };
}
