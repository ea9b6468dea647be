#pragma once
// What all benchmarks of the solver have in common.

#include <benchmark/benchmark.h>
#include <oneapi/tbb/global_control.h>

namespace vesicle::benchmarks
{

/// As many threads as long as it lives.
class Threads
{
public:
  explicit Threads(std::size_t number)
    : control_(oneapi::tbb::global_control::max_allowed_parallelism, number)
  {
  }

private:
  oneapi::tbb::global_control control_;
};

/// Wall times, and beside them what all threads of the process took of the processors.
inline void with_all_threads(benchmark::internal::Benchmark* benchmark)
{
  benchmark->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);
}

/// The most memory that this process had so far, in bytes (Linux's VmHWM); 0 where it isn't told.
double peak_memory();

}
