#pragma once
// A file that grows or changes in place while a run goes on.

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace vesicle
{

/// An existing file, open for writing until the object ends. Every function throws IoError naming
/// the file and the system's reason.
class OpenFile
{
public:
  explicit OpenFile(std::filesystem::path file);
  ~OpenFile();
  OpenFile(OpenFile&& other) noexcept;
  OpenFile& operator=(OpenFile&& other) noexcept;

  /// Changes bytes in place; the file doesn't grow beyond them.
  void write_at(std::uint64_t place, std::string_view bytes);
  /// Adds bytes at the end: all of them, or none where that fails.
  void append(std::string_view bytes);
  /// Returns when what was written is on the disk. Throws as well where the file was removed.
  void sync();

private:
  [[noreturn]] void fail(int reason) const;
  void close();

  std::filesystem::path file_;
  int descriptor_ = -1;
  std::uint64_t length_ = 0;
};

}
