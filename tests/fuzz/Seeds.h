#pragma once
// The seeds of the targets, and files damaged from them.

#include <filesystem>
#include <string>
#include <vector>

namespace vesicle::fuzz
{

/// Those in tests/fuzz/seeds, and the shipped scenes where the target takes scenes.
std::vector<std::filesystem::path> seeds_of(const std::string& target);
/// The damaged form of that number, each of another seed than the one before; the same each time.
std::string damaged_seed(const std::vector<std::filesystem::path>& seeds, int number);

}
