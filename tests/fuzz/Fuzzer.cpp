// A target (VESICLE_FUZZ_TARGET) under libFuzzer.
#include "tests/fuzz/Targets.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  vesicle::fuzz::VESICLE_FUZZ_TARGET({ reinterpret_cast<const char*>(data), size });
  return 0;
}
