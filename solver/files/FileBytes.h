#pragma once
// Files that are there as a whole or not at all. Together with OpenFile and FileLock this is the
// one place where the program writes to a disk.

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>

namespace vesicle
{

/// Writes beside `file` under another name, brings that to the disk, then renames it: whoever reads
/// `file` finds the old content or the new one, also after the program or the machine crashed.
/// Throws IoError naming the file and the system's reason; `file` is then what it was. A link stays
/// a link, and what it points to is replaced.
void replace_file(const std::filesystem::path& file, std::string_view bytes);

/// The name used for that: NAME.part.ENDING in the same folder (`file` itself where that is a
/// device).
std::filesystem::path unfinished_name(const std::filesystem::path& file);
/// Gives a file that another program or library wrote under its unfinished name its own, once it is
/// on the disk. Throws IoError; nothing unfinished is then left.
void finish_file(const std::filesystem::path& file);

/// Whether something is there, a file, or a folder. None throws, as std::filesystem does for names
/// that the system doesn't take: too long, links that go round.
bool is_there(const std::filesystem::path& path);
bool is_file(const std::filesystem::path& path);
bool is_folder(const std::filesystem::path& path);

/// All of a file or of what comes through a pipe, up to 1 GiB. A pipe is read until nobody has it open
/// for writing any more; `patience` is how long it is waited for somebody to do so at all. Throws
/// InputError if there is nothing to read, IoError if it can't be.
std::string read_file(
  const std::filesystem::path& file, std::chrono::milliseconds patience = std::chrono::seconds(10));
/// Throws InputError unless there is a file or a pipe.
void require_file(const std::filesystem::path& file);
/// Makes the folder and those above it. Throws IoError.
void make_folder(const std::filesystem::path& folder);

}
