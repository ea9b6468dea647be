#include "solver/state/WholeFile.h"

#include "solver/Errors.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace vesicle
{
namespace
{

[[noreturn]] void fail(const std::filesystem::path& file, int reason)
{
  throw IoError(file.string() + ": can't be written: " + std::generic_category().message(reason));
}

/// 0, or the system's error number.
int write_all(int descriptor, const std::vector<char>& bytes)
{
  std::size_t written = 0;
  while (written < bytes.size())
  {
    const ssize_t count = ::write(descriptor, bytes.data() + written, bytes.size() - written);
    if (count < 0 && errno != EINTR)
    {
      return errno;
    }
    written += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  return ::fsync(descriptor) == 0 ? 0 : errno;
}

}

void write_whole_file(
  const std::filesystem::path& file, const std::vector<char>& bytes, IfExists if_exists)
{
  const int mode = if_exists == IfExists::fail ? O_EXCL : O_TRUNC;
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | mode, 0666);
  if (descriptor < 0)
  {
    fail(file, errno);
  }
  int reason = write_all(descriptor, bytes);
  if (::close(descriptor) != 0 && reason == 0)
  {
    reason = errno;
  }
  if (reason != 0)
  {
    ::unlink(file.c_str());
    fail(file, reason);
  }
}

}
