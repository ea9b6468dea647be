#include "solver/files/OpenFile.h"

#include "solver/files/SystemCalls.h"

#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace vesicle
{

OpenFile::OpenFile(std::filesystem::path file)
  : file_(std::move(file)), descriptor_(::open(file_.c_str(), O_WRONLY | O_CLOEXEC))
{
  struct stat status = {};
  if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0)
  {
    const int reason = errno;
    close();
    fail(reason);
  }
  length_ = static_cast<std::uint64_t>(status.st_size);
}

OpenFile::~OpenFile()
{
  close();
}

OpenFile::OpenFile(OpenFile&& other) noexcept
  : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)),
    length_(other.length_)
{
}

OpenFile& OpenFile::operator=(OpenFile&& other) noexcept
{
  std::swap(file_, other.file_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(length_, other.length_);
  return *this;
}

void OpenFile::close()
{
  if (descriptor_ >= 0)
  {
    ::close(std::exchange(descriptor_, -1)); // what counts was synced, and told if it failed
  }
}

void OpenFile::fail(int reason) const
{
  system_calls::fail_to_write(file_, reason);
}

void OpenFile::write_at(std::uint64_t place, std::string_view bytes)
{
  if (const int reason = system_calls::write_all_at(descriptor_, bytes, place))
  {
    fail(reason);
  }
}

void OpenFile::append(std::string_view bytes)
{
  if (const int reason = system_calls::write_all_at(descriptor_, bytes, length_))
  {
    // Half a line is worse than none. Where this fails too, the error is told all the same.
    [[maybe_unused]] const int ignored = ::ftruncate(descriptor_, static_cast<off_t>(length_));
    fail(reason);
  }
  length_ += bytes.size();
}

void OpenFile::sync()
{
  struct stat status = {};
  if (::fstat(descriptor_, &status) != 0)
  {
    fail(errno);
  }
  if (status.st_nlink == 0)
  {
    system_calls::fail_to_write(file_, "it was removed while it was in use");
  }
  if (const int reason = system_calls::sync_bytes(descriptor_))
  {
    fail(reason);
  }
}

}
