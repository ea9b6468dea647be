#pragma once
// The system's calls on files, each repeated until it did what it was asked for. Include in sources
// only.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace vesicle::system_calls
{

/// All return 0 or the system's error number.
int write_all(int descriptor, std::string_view bytes);
int write_all_at(int descriptor, std::string_view bytes, std::uint64_t place);
/// To the disk. Where a file system knows no such thing, there is nothing to wait for.
int sync(int descriptor);
int sync_bytes(int descriptor); ///< and the length, not the times: several times quicker
int sync_folder(const std::filesystem::path& folder);

/// Throws IoError "file: can't be written: reason".
[[noreturn]] void fail_to_write(const std::filesystem::path& file, int reason);
[[noreturn]] void fail_to_write(const std::filesystem::path& file, const std::string& reason);

}
