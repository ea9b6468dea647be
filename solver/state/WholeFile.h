#pragma once
// Writing a file from first to last byte, onto the disk.

#include <filesystem>
#include <vector>

namespace vesicle
{

enum class IfExists
{
  fail,
  replace
};

/// Returns when the bytes are on the disk. Throws IoError naming the file and the system's reason;
/// a file that was begun is then removed.
void write_whole_file(
  const std::filesystem::path& file, const std::vector<char>& bytes, IfExists if_exists);

}
