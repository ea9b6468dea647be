#pragma once
// States and rows to save in tests: any values, different in every step, the same every time.

#include "solver/state/RunFile.h"

#include <cstdint>

namespace vesicle::testing_support
{

RunFile::Header header();
State state(std::int64_t step, int vertices = 42);
std::vector<std::optional<double>> row(std::int64_t step);
/// An empty folder of this name.
std::filesystem::path empty_folder(const std::string& name);

/// Every bit of every field, signs of zeros and payloads included.
bool same_bits(const State& a, const State& b);

}
