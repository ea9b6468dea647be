#include "solver/stokes/kernels/StokesletLoops.inl.h"

const vesicle::StokesletLoops& vesicle::avx2_loops()
{
  return loops;
}
