#include "tests/benchmarks/Measuring.h"

#include <fstream>
#include <string>

namespace vesicle::benchmarks
{

double peak_memory()
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kilobytes = 0; word == "VmHWM:" && status >> kilobytes)
      return 1024 * kilobytes;
  return 0;
}

}
