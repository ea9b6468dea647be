#include "solver/stokes/kernels/StokesletLoops.inl.h"

const vesicle::StokesletLoops& vesicle::avx512_loops()
{
  return loops;
}
