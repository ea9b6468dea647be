#pragma once
// What one core can do at the most in an instruction set: loops written for it by hand, beside the
// solver's own.

#include "solver/stokes/kernels/StokesletLoops.h"

#include <vector>

namespace vesicle::benchmarks
{

template<class Real>
struct HandWritten
{
  /// Multiplications and additions in registers alone; returns what keeps them from being left out.
  Real (*multiply_add)(long rounds);
  long flop_a_round;
  /// As add_points, of as many targets.
  void (*add_stokeslets)(
    const PointForces<Real>& forces, const Coordinate<Real>* targets, double* velocities);
  int targets;
};

struct InstructionSet
{
  const char* name;
  HandWritten<double> in_double;
  HandWritten<float> in_single;
  const StokesletLoops& ours;
};

#ifdef VESICLE_X86_LOOPS
InstructionSet avx2();
InstructionSet avx512();
#endif
/// Those of this processor that there are loops for, the widest first.
std::vector<InstructionSet> instruction_sets();

}
