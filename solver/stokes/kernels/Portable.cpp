#include "solver/stokes/kernels/StokesletLoops.inl.h"

const vesicle::StokesletLoops& vesicle::portable_loops()
{
  return loops;
}
