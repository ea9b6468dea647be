#include "solver/linear/Blas.h"

#include <algorithm>
#include <cblas.h>
#include <cstdlib>
#include <initializer_list>
#include <unistd.h>

namespace vesicle
{

namespace
{

bool is_one_of(const std::string& kernel, std::initializer_list<const char*> names)
{
  return std::find(names.begin(), names.end(), kernel) != names.end();
}

// The kernel that this processor should run instead of the one that OpenBLAS chose; null: let it
// be.
const char* better_kernel([[maybe_unused]] const std::string& chosen)
{
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
    __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"))
    return is_one_of(chosen, { "SkylakeX", "Cooperlake", "SapphireRapids" }) ? nullptr : "SKYLAKEX";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return is_one_of(chosen, { "Prescott", "Core2", "Nehalem", "Barcelona", "Generic" }) ? "HASWELL"
                                                                                         : nullptr;
#endif
  return nullptr;
}

}

std::string blas_kernel()
{
  return openblas_get_corename();
}

void use_one_blas_thread()
{
  static const bool done = (openblas_set_num_threads(1), true);
  static_cast<void>(done);
}

void restart_with_blas_kernel(char** argv)
{
  const char* kernel = better_kernel(blas_kernel());
  if (!kernel || std::getenv("OPENBLAS_CORETYPE"))
    return;
  setenv("OPENBLAS_CORETYPE", kernel, 1);
  execv("/proc/self/exe", argv); // returns only if it failed: then go on, more slowly
}

}
