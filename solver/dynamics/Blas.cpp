#include "solver/dynamics/Blas.h"

#include <cstdlib>
#include <cstring>
#include <unistd.h>

extern "C" char* openblas_get_corename(void);

namespace vesicle
{

namespace
{

const char* wanted_kernel()
{
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
    __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"))
    return "SKYLAKEX";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return "HASWELL";
#endif
  return nullptr;
}

bool is_generic(const std::string& kernel)
{
  for (const char* old : { "Prescott", "Core2", "Nehalem", "Barcelona", "Generic" })
    if (kernel == old)
      return true;
  return false;
}

}

std::string blas_kernel()
{
  return openblas_get_corename();
}

void restart_with_blas_kernel(char** argv)
{
  const char* kernel = wanted_kernel();
  if (!kernel || std::getenv("OPENBLAS_CORETYPE") || !is_generic(blas_kernel()))
    return;
  setenv("OPENBLAS_CORETYPE", kernel, 1);
  execv("/proc/self/exe", argv); // returns only if it failed: then go on, more slowly
}

}
