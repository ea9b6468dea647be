#pragma once
// Four numbers that are worked on at once. For functions that are compiled for several instruction
// sets (Multiversion.h) and inlined into them: a register of AVX2, two of SSE2. (Vectors of 64 bytes
// are slow where they are two registers: docs/performance.md, kernels.)

#include "solver/Multiversion.h"

namespace vesicle
{

inline constexpr int lanes = 4;
template<class Scalar>
struct LanesOf
{
  /// Read and written wherever they are.
  using type
    [[gnu::vector_size(lanes * sizeof(Scalar)), gnu::aligned(alignof(Scalar)), gnu::may_alias]] =
      Scalar;
};
using Lanes = LanesOf<double>::type;

template<class Scalar>
VESICLE_INLINE const typename LanesOf<Scalar>::type& lanes_at(const Scalar* a)
{
  return *reinterpret_cast<const typename LanesOf<Scalar>::type*>(a);
}
template<class Scalar>
VESICLE_INLINE typename LanesOf<Scalar>::type& lanes_at(Scalar* a)
{
  return *reinterpret_cast<typename LanesOf<Scalar>::type*>(a);
}
VESICLE_INLINE double sum_of(const Lanes& v)
{
  return (v[0] + v[2]) + (v[1] + v[3]);
}
/// Up to a multiple of them.
constexpr int in_lanes(int count)
{
  return (count + lanes - 1) / lanes * lanes;
}

}
