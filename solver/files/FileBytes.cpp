#include "solver/files/FileBytes.h"

#include "solver/Errors.h"
#include "solver/files/SystemCalls.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace vesicle
{
namespace
{

using std::filesystem::path;
using system_calls::fail_to_write;

/// 0, or the system's error number. To the disk, unless it is a device.
int write_bytes(const path& to, std::string_view bytes)
{
  const int descriptor = ::open(to.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0)
  {
    return errno;
  }
  int reason = system_calls::write_all(descriptor, bytes);
  if (reason == 0)
  {
    reason = system_calls::sync(descriptor);
  }
  if (::close(descriptor) != 0 && reason == 0)
  {
    reason = errno;
  }
  return reason;
}

int sync_file(const path& file)
{
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0)
  {
    return errno;
  }
  const int reason = system_calls::sync(descriptor);
  return ::close(descriptor) != 0 && reason == 0 ? errno : reason;
}

/// What `file` leads to, be it there or not.
path behind_links(path file)
{
  constexpr int most_links = 40; // the system's own limit
  std::error_code none;
  for (int i = 0; i < most_links && std::filesystem::is_symlink(file, none); ++i)
  {
    file = file.parent_path() / std::filesystem::read_symlink(file, none);
  }
  return file;
}

/// 0, or the system's error number.
int rename_to(const path& unfinished, const path& file)
{
  if (::rename(unfinished.c_str(), file.c_str()) != 0)
  {
    return errno;
  }
  return system_calls::sync_folder(file.parent_path());
}

/// Half a file is worse than none; a device stays.
[[noreturn]] void give_up(const path& unfinished, const path& file, int reason)
{
  if (is_file(unfinished))
  {
    ::unlink(unfinished.c_str());
  }
  fail_to_write(file, reason);
}

/// Beside the system's error numbers.
constexpr int nothing_came = -1;
/// What comes through a pipe has no length that could be looked at before.
constexpr std::size_t most_of_a_pipe = std::size_t{ 1 } << 30;

bool is_pipe(int descriptor)
{
  struct stat status = {};
  return ::fstat(descriptor, &status) == 0 && S_ISFIFO(status.st_mode);
}

/// Until something comes, or nothing will, or for that time; −1: for ever.
void await(int descriptor, std::chrono::milliseconds time)
{
  pollfd awaited{ descriptor, POLLIN, 0 };
  while (::poll(&awaited, 1, static_cast<int>(time.count())) < 0 && errno == EINTR)
  {
  }
}

/// 0, the system's error number, or nothing_came. A pipe is waited for as long as somebody has it
/// open for writing, for who does that first `patience`.
int read_all(int descriptor, std::chrono::milliseconds patience, std::string& bytes)
{
  const bool pipe = is_pipe(descriptor);
  bool waited = !pipe;
  std::array<char, 65536> piece;
  for (;;)
  {
    const ssize_t count = ::read(descriptor, piece.data(), piece.size());
    if (count > 0)
    {
      bytes.append(piece.data(), static_cast<std::size_t>(count));
    }
    else if (count == 0 && bytes.empty() && !waited)
    {
      await(descriptor, patience);
      waited = true;
    }
    else if (count == 0)
    {
      return pipe && bytes.empty() ? nothing_came : 0;
    }
    else if (errno == EAGAIN)
    {
      await(descriptor, std::chrono::milliseconds(-1));
    }
    else if (errno != EINTR)
    {
      return errno;
    }
    if (pipe && bytes.size() > most_of_a_pipe)
    {
      return EFBIG;
    }
  }
}

}

path unfinished_name(const path& file)
{
  std::error_code ignored;
  const auto status = std::filesystem::status(file, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
  {
    return file; // a device or a pipe is written to, not replaced
  }
  auto name = behind_links(file);
  return name.replace_filename(name.stem().string() + ".part" + name.extension().string());
}

void finish_file(const path& file)
{
  const path unfinished = unfinished_name(file);
  if (unfinished == file)
  {
    return;
  }
  int reason = sync_file(unfinished);
  if (reason == 0)
  {
    reason = rename_to(unfinished, behind_links(file));
  }
  if (reason != 0)
  {
    give_up(unfinished, file, reason);
  }
}

void replace_file(const path& file, std::string_view bytes)
{
  const path unfinished = unfinished_name(file);
  int reason = write_bytes(unfinished, bytes);
  if (reason == 0 && unfinished != file)
  {
    reason = rename_to(unfinished, behind_links(file));
  }
  if (reason != 0)
  {
    give_up(unfinished, file, reason);
  }
}

bool is_there(const path& path)
{
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

bool is_file(const path& path)
{
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

bool is_folder(const std::filesystem::path& path)
{
  std::error_code unknown;
  return std::filesystem::is_directory(path, unknown);
}

void require_file(const path& file)
{
  std::error_code ignored;
  const auto kind = std::filesystem::status(file, ignored).type();
  const auto refuse = [&](const char* why)
  { throw InputError(fmt::format("{}: {}", file.string(), why)); };
  if (kind == std::filesystem::file_type::directory)
  {
    refuse("is a folder; name a file");
  }
  if (kind == std::filesystem::file_type::character || kind == std::filesystem::file_type::block ||
    kind == std::filesystem::file_type::socket)
  {
    refuse("is a device or a socket; name a file or a pipe");
  }
  if (!is_there(file))
  {
    refuse("there is no such file; check the path");
  }
}

std::string read_file(const path& file, std::chrono::milliseconds patience)
{
  require_file(file);
  // A pipe that nobody writes to would be waited for while it is opened.
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  std::string bytes;
  const int reason = descriptor < 0 ? errno : read_all(descriptor, patience, bytes);
  if (descriptor >= 0)
  {
    ::close(descriptor);
  }
  if (reason == nothing_came)
  {
    throw InputError(
      fmt::format("{}: is a pipe that nobody wrote to; start the program that does, or name a file",
        file.string()));
  }
  if (reason != 0)
  {
    throw IoError(
      fmt::format("{}: can't be read: {}", file.string(), std::generic_category().message(reason)));
  }
  return bytes;
}

void make_folder(const path& folder)
{
  std::error_code error;
  const bool made = std::filesystem::create_directories(folder, error);
  if (error)
  {
    fail_to_write(folder, error.message());
  }
  if (const int reason = made ? system_calls::sync_folder(folder.parent_path()) : 0)
  {
    fail_to_write(folder, reason);
  }
}

}
