#include "solver/files/SystemCalls.h"

#include "solver/Errors.h"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace vesicle::system_calls
{
namespace
{

/// `write_some(bytes)` is the call; it may take a part of them.
template<class Write>
int write_until_done(std::string_view bytes, const Write& write_some)
{
  while (!bytes.empty())
  {
    const ssize_t count = write_some(bytes);
    if (count < 0 && errno != EINTR)
    {
      return errno;
    }
    if (count == 0)
    {
      return EIO; // nothing taken and nothing said: don't try for ever
    }
    bytes.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
  }
  return 0;
}

}

int write_all(int descriptor, std::string_view bytes)
{
  return write_until_done(
    bytes, [&](std::string_view rest) { return ::write(descriptor, rest.data(), rest.size()); });
}

int write_all_at(int descriptor, std::string_view bytes, std::uint64_t place)
{
  const char* const begin = bytes.data();
  return write_until_done(bytes,
    [&](std::string_view rest)
    {
      const auto at = static_cast<off_t>(place) + (rest.data() - begin);
      return ::pwrite(descriptor, rest.data(), rest.size(), at);
    });
}

int sync_bytes(int descriptor)
{
  return ::fdatasync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno;
}

int sync(int descriptor)
{
  return ::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno;
}

int sync_folder(const std::filesystem::path& folder)
{
  const auto place = folder.empty() ? std::filesystem::path(".") : folder;
  const int descriptor = ::open(place.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0)
  {
    return errno == EACCES ? 0 : errno; // a folder that may be written to and not read
  }
  const int reason = sync(descriptor);
  ::close(descriptor);
  return reason;
}

void fail_to_write(const std::filesystem::path& file, const std::string& reason)
{
  throw IoError(fmt::format("{}: can't be written: {}", file.string(), reason));
}

void fail_to_write(const std::filesystem::path& file, int reason)
{
  fail_to_write(file, std::generic_category().message(reason));
}

}
