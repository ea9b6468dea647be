#include "solver/files/FileBytes.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

namespace vesicle
{
namespace
{

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason)
{
  throw IoError(fmt::format("{}: can't be written: {}", file.string(), reason));
}

/// Half a file is worse than none.
void remove_regular(const std::filesystem::path& file)
{
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file, ignored))
  {
    std::filesystem::remove(file, ignored);
  }
}

/// An error names `file`, which these bytes become in the end.
void write_bytes(const std::filesystem::path& unfinished, const std::filesystem::path& file,
  std::string_view bytes)
{
  errno = 0;
  std::ofstream out(unfinished, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out)
  {
    const int reason = errno;
    remove_regular(unfinished);
    fail(file, reason ? std::strerror(reason) : "unknown reason");
  }
}

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
  write_bytes(unfinished_name(file), file, bytes);
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
