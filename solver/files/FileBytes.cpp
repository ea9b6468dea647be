#include "solver/files/FileBytes.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace vesicle
{
namespace
{

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason)
{
  throw IoError(fmt::format("{}: can't be written: {}", file.string(), reason));
}

/// Half a file is worse than none; a device stays.
void remove_regular(const std::filesystem::path& file)
{
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file, ignored))
  {
    std::filesystem::remove(file, ignored);
  }
}

/// 0, or the system's error number.
int write_all(int descriptor, std::string_view bytes)
{
  while (!bytes.empty())
  {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR)
    {
      return errno;
    }
    bytes.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
  }
  return 0;
}

enum class Until
{
  taken, ///< by the system
  on_disk
};

/// An error names `file`, which the bytes written to `to` become in the end.
void write_bytes(const std::filesystem::path& to, const std::filesystem::path& file,
  std::string_view bytes, IfExists if_exists, Until until)
{
  const int mode = if_exists == IfExists::fail ? O_EXCL : O_TRUNC;
  const int descriptor = ::open(to.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | mode, 0666);
  if (descriptor < 0)
  {
    fail(file, std::generic_category().message(errno));
  }
  int reason = write_all(descriptor, bytes);
  if (reason == 0 && until == Until::on_disk && ::fsync(descriptor) != 0)
  {
    reason = errno;
  }
  if (::close(descriptor) != 0 && reason == 0)
  {
    reason = errno;
  }
  if (reason != 0)
  {
    remove_regular(to);
    fail(file, std::generic_category().message(reason));
  }
}

}

void write_to_disk(const std::filesystem::path& file, std::string_view bytes, IfExists if_exists)
{
  write_bytes(file, file, bytes, if_exists, Until::on_disk);
}

std::filesystem::path unfinished_name(const std::filesystem::path& file)
{
  std::error_code ignored;
  const auto status = std::filesystem::status(file, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
  {
    return file; // a device or a pipe is written to, not replaced
  }
  auto name = file;
  return name.replace_filename(file.stem().string() + ".part" + file.extension().string());
}

void finish_file(const std::filesystem::path& file)
{
  const auto unfinished = unfinished_name(file);
  if (unfinished == file)
  {
    return;
  }
  std::error_code error;
  std::filesystem::rename(unfinished, file, error);
  if (error)
  {
    std::error_code ignored;
    std::filesystem::remove(unfinished, ignored);
    fail(file, error.message());
  }
}

void replace_file(const std::filesystem::path& file, std::string_view bytes)
{
  write_bytes(unfinished_name(file), file, bytes, IfExists::replace, Until::taken);
  finish_file(file);
}

void require_file(const std::filesystem::path& file)
{
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
  {
    throw InputError(fmt::format("{}: there is no such file; check the path", file.string()));
  }
  if (std::filesystem::is_directory(file, ignored))
  {
    throw InputError(fmt::format("{}: is a folder; name a file", file.string()));
  }
}

std::string read_file(const std::filesystem::path& file)
{
  require_file(file);
  std::ifstream in(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  if (!in)
  {
    throw IoError(fmt::format("{}: can't be read", file.string()));
  }
  return bytes.str();
}

void make_folder(const std::filesystem::path& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
  {
    fail(folder, error.message());
  }
}

}
