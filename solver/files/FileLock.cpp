#include "solver/files/FileLock.h"

#include "solver/Errors.h"
#include "solver/files/SystemCalls.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace vesicle
{
namespace
{

/// Who holds a lock; a line in its file.
struct Holder
{
  std::string host;
  long process = 0;
};

std::string host_name()
{
  std::array<char, 256> name{};
  ::gethostname(name.data(), name.size() - 1);
  return name.data();
}

std::optional<Holder> holder_in(int descriptor)
{
  std::array<char, 300> text{};
  const ssize_t length = ::pread(descriptor, text.data(), text.size() - 1, 0);
  Holder holder;
  std::istringstream words(length > 0 ? text.data() : "");
  return words >> holder.process >> holder.host ? std::optional(holder) : std::nullopt;
}

std::string text_of(const Holder& holder)
{
  return fmt::format("process {} on {}", holder.process, holder.host);
}

bool has_ended(const Holder& holder)
{
  return holder.host == host_name() && ::kill(static_cast<pid_t>(holder.process), 0) != 0 &&
    errno == ESRCH;
}

bool same_file(int descriptor, const std::filesystem::path& file)
{
  struct stat open = {}, named = {};
  return ::fstat(descriptor, &open) == 0 && ::stat(file.c_str(), &named) == 0 &&
    open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

[[noreturn]] void refuse(
  const std::filesystem::path& file, const std::optional<Holder>& holder, const std::string& remedy)
{
  const auto who = holder ? fmt::format(" ({})", text_of(*holder)) : std::string();
  throw IoError(fmt::format("{}: locked by another run{}; {}", file.string(), who, remedy));
}

}

FileLock::FileLock(std::filesystem::path file) : file_(std::move(file))
{
  try
  {
    while (!try_to_lock())
    {
      release();
    }
    take_down_holder();
  }
  catch (...)
  {
    release();
    throw;
  }
}

FileLock::~FileLock()
{
  ::unlink(file_.c_str());
  release();
}

void FileLock::release()
{
  if (descriptor_ >= 0)
  {
    ::close(std::exchange(descriptor_, -1));
  }
}

/// False where it is to be tried again: the file has just been removed by its holder.
bool FileLock::try_to_lock()
{
  descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  const bool created = descriptor_ >= 0;
  if (!created && errno == EEXIST)
  {
    descriptor_ = ::open(file_.c_str(), O_RDWR | O_CLOEXEC);
    if (descriptor_ < 0 && errno == ENOENT)
    {
      return false;
    }
  }
  if (descriptor_ < 0)
  {
    system_calls::fail_to_write(file_, errno);
  }
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0)
  {
    return same_file(descriptor_, file_);
  }
  if (errno == EWOULDBLOCK || errno == EINTR)
  {
    refuse(file_, holder_in(descriptor_), "wait for it or end it");
  }
  if (!created)
  {
    remove_leftover();
  }
  return created;
}

/// Where there are no locks: the file itself is one.
void FileLock::remove_leftover()
{
  const auto holder = holder_in(descriptor_);
  if (!holder || !has_ended(*holder))
  {
    refuse(file_, holder, "wait for it or end it; if it has ended already, remove this file");
  }
  if (same_file(descriptor_, file_))
  {
    ::unlink(file_.c_str());
  }
}

void FileLock::take_down_holder()
{
  const auto line = fmt::format("{} {}\n", ::getpid(), host_name());
  int reason = ::ftruncate(descriptor_, 0) == 0 ? 0 : errno;
  if (reason == 0)
  {
    reason = system_calls::write_all_at(descriptor_, line, 0);
  }
  if (reason != 0)
  {
    ::unlink(file_.c_str());
    system_calls::fail_to_write(file_, reason);
  }
}

std::string lock_holder(const std::filesystem::path& file)
{
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0)
  {
    return {};
  }
  const auto holder = holder_in(descriptor);
  ::close(descriptor);
  return holder && !has_ended(*holder) ? text_of(*holder) : std::string();
}

}
