// Speed beside the machine's own: bash tests/benchmarks/run.sh runs all of it and makes a table.
#include "solver/KeptMemory.h"
#include "solver/linear/Blas.h"

#include <benchmark/benchmark.h>

#include <fstream>
#include <string>

// As Linux calls it; empty where it doesn't.
static std::string processor()
{
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name"))
      return line.substr(line.find(':') + 2);
  return {};
}

int main(int argc, char** argv)
{
  vesicle::restart_with_blas_kernel(argv);
  vesicle::keep_freed_memory();
  benchmark::AddCustomContext("BLAS kernel", vesicle::blas_kernel());
  benchmark::AddCustomContext("processor", processor());
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  benchmark::RunSpecifiedBenchmarks();
}
