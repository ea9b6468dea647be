#pragma once
// What a run to its end leaves behind.

#include <cstddef>
#include <filesystem>

namespace vesicle::test
{

/// False on a machine that has nothing to draw pictures with.
bool draws(const std::filesystem::path& run);

/// Expects the folder's files: a series of at least this many frames, a table of numbers without
/// NaN, a summary that says "finished" or "steady" and, where the machine draws, the plots and a
/// picture a frame.
void expect_complete_run(const std::filesystem::path& run, std::size_t frames);

}
