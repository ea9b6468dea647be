#include "tests/benchmarks/InstructionSet.h"

namespace vesicle::benchmarks
{

std::vector<InstructionSet> instruction_sets()
{
  std::vector<InstructionSet> sets;
#ifdef VESICLE_X86_LOOPS
  __builtin_cpu_init(); // registered before main()
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
    __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
    __builtin_cpu_supports("avx512vl"))
    sets.push_back(avx512());
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    sets.push_back(avx2());
#endif
  return sets;
}

}
