#pragma once
// Numbers too small to be normal are taken for zero while this lives, on this thread. Factors whose
// entries fall off exponentially are full of them in single precision, and processors need a hundred
// cycles for each.

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace vesicle
{

class FlushDenormals
{
public:
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;
#ifdef __SSE2__
  FlushDenormals()
  {
    _mm_setcsr(before_ | results_are_zero | operands_are_zero);
  }
  ~FlushDenormals()
  {
    _mm_setcsr(before_);
  }

private:
  static constexpr unsigned results_are_zero = 0x8000, operands_are_zero = 0x0040;
  const unsigned before_ = _mm_getcsr();
#else
  FlushDenormals() {}
  ~FlushDenormals() {}
#endif
};

}
