#pragma once
// Files that are there as a whole or not at all.

#include <filesystem>
#include <string>
#include <string_view>

namespace vesicle
{

enum class IfExists
{
  fail,
  replace
};

/// Writes the file itself and returns when the bytes are on the disk. Throws IoError naming the
/// file and the system's reason; a file that was begun is then removed.
void write_to_disk(const std::filesystem::path& file, std::string_view bytes, IfExists if_exists);

/// Writes beside `file` under another name, then renames: whoever reads `file` finds the old
/// content or the new one, also after a crash of the program. Throws IoError as above.
void replace_file(const std::filesystem::path& file, std::string_view bytes);

/// The name used for that: NAME.part.ENDING in the same folder (`file` itself where that is a
/// device).
std::filesystem::path unfinished_name(const std::filesystem::path& file);
/// Gives a file that was written under its unfinished name its own. Throws IoError.
void finish_file(const std::filesystem::path& file);

/// Throws InputError if there is none, IoError if it can't be read.
std::string read_file(const std::filesystem::path& file);
/// Throws InputError unless there is a file.
void require_file(const std::filesystem::path& file);
/// Makes the folder and those above it. Throws IoError.
void make_folder(const std::filesystem::path& folder);

}
