// A disk that fails at a call: preloaded into a program, it counts the calls by which the program and
// its children change what is in a folder, and has one of them fail. For tests; set by
//   FAULTY_FOLDER   the folder, an absolute path
//   FAULTY_COUNTER  a file of 8 bytes outside of it: the number of calls so far
//   FAULTY_CALL     the number of the call, from 1; 0 or none: all succeed
//   FAULTY_KIND     ENOSPC, EDQUOT or EIO: its error; "short": a write takes half of its bytes;
//                   "kill": the program is killed in it, a write halfway
//   FAULTY_LASTING  1: all later calls that need room (for EIO: all) fail as well
//   FAULTY_DELAY    microseconds that each sync takes: the disk is behind the program then
// Nothing waits for the real disk.

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace
{

enum class Fate
{
  success,
  error,
  half ///< of the bytes
};

/// What a full disk refuses.
enum class Needs
{
  room,
  nothing
};

std::string_view setting(const char* name)
{
  const char* const value = std::getenv(name);
  return value ? value : "";
}

std::atomic<std::int64_t>* shared_counter()
{
  static std::atomic<std::int64_t>* const counter = []
  {
    const int file =
      static_cast<int>(::syscall(SYS_openat, AT_FDCWD, setting("FAULTY_COUNTER").data(), O_RDWR));
    void* const memory = file >= 0
      ? ::mmap(nullptr, sizeof(std::int64_t), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0)
      : MAP_FAILED;
    if (file >= 0)
    {
      ::syscall(SYS_close, file);
    }
    return memory == MAP_FAILED ? nullptr : static_cast<std::atomic<std::int64_t>*>(memory);
  }();
  return counter;
}

int error_number()
{
  const auto kind = setting("FAULTY_KIND");
  return kind == "ENOSPC" ? ENOSPC : kind == "EDQUOT" ? EDQUOT : EIO;
}

[[noreturn]] void die()
{
  ::raise(SIGKILL);
  std::abort();
}

/// Of the next call.
Fate fate(Needs needs, bool writes = false)
{
  std::atomic<std::int64_t>* const counter = shared_counter();
  if (!counter)
  {
    return Fate::success;
  }
  const std::int64_t call = ++*counter, chosen = std::atoll(setting("FAULTY_CALL").data());
  const auto kind = setting("FAULTY_KIND");
  const bool error = kind.starts_with("E");
  const bool lasts = error && setting("FAULTY_LASTING") == "1" && call > chosen &&
    (needs == Needs::room || kind == "EIO");
  if (chosen == 0 || (call != chosen && !lasts))
  {
    return Fate::success;
  }
  if (kind == "kill" && !writes)
  {
    die();
  }
  return error ? Fate::error : writes ? Fate::half : Fate::success;
}

bool inside(std::string_view path)
{
  const auto folder = setting("FAULTY_FOLDER");
  return !folder.empty() && path.starts_with(folder) &&
    (path.size() == folder.size() || path[folder.size()] == '/');
}

bool names_inside(const char* name)
{
  std::array<char, PATH_MAX> here{};
  if (name[0] == '/' || !::getcwd(here.data(), here.size()))
  {
    return inside(name);
  }
  return inside(std::string(here.data()) + "/" + name);
}

bool is_inside(int descriptor)
{
  std::array<char, 64> link{};
  std::array<char, PATH_MAX> path{};
  std::snprintf(link.data(), link.size(), "/proc/self/fd/%d", descriptor);
  return ::readlink(link.data(), path.data(), path.size() - 1) > 0 && inside(path.data());
}

int fail()
{
  errno = error_number();
  return -1;
}

template<class Write>
ssize_t faulty_write(int descriptor, std::size_t size, const Write& write)
{
  const Fate next = size > 0 && is_inside(descriptor) ? fate(Needs::room, true) : Fate::success;
  if (next == Fate::error)
  {
    return fail();
  }
  if (next == Fate::success)
  {
    return write(size);
  }
  const ssize_t written = write((size + 1) / 2);
  if (setting("FAULTY_KIND") == "kill")
  {
    die();
  }
  return written;
}

int faulty_open(const char* name, int flags, mode_t mode)
{
  const bool changes = (flags & (O_WRONLY | O_RDWR | O_CREAT | O_TRUNC)) != 0;
  const bool counts = (changes || (flags & O_DIRECTORY)) && names_inside(name);
  if (counts && fate(flags & O_CREAT ? Needs::room : Needs::nothing) == Fate::error)
  {
    return fail();
  }
  return static_cast<int>(::syscall(SYS_openat, AT_FDCWD, name, flags, mode));
}

mode_t mode_in(int flags, va_list list)
{
  return flags & (O_CREAT | O_TMPFILE) ? static_cast<mode_t>(va_arg(list, int)) : 0;
}

int faulty_sync(int descriptor)
{
  ::usleep(static_cast<useconds_t>(std::atoi(setting("FAULTY_DELAY").data())));
  return is_inside(descriptor) && fate(Needs::room) == Fate::error ? fail() : 0;
}

}

extern "C"
{

  int open(const char* name, int flags, ...)
  {
    va_list list;
    va_start(list, flags);
    const mode_t mode = mode_in(flags, list);
    va_end(list);
    return faulty_open(name, flags, mode);
  }

  int open64(const char* name, int flags, ...)
  {
    va_list list;
    va_start(list, flags);
    const mode_t mode = mode_in(flags, list);
    va_end(list);
    return faulty_open(name, flags, mode);
  }

  ssize_t write(int descriptor, const void* bytes, size_t size)
  {
    return faulty_write(descriptor, size,
      [&](std::size_t part) { return ::syscall(SYS_write, descriptor, bytes, part); });
  }

  ssize_t pwrite(int descriptor, const void* bytes, size_t size, off_t place)
  {
    return faulty_write(descriptor, size,
      [&](std::size_t part) { return ::syscall(SYS_pwrite64, descriptor, bytes, part, place); });
  }

  ssize_t pwrite64(int descriptor, const void* bytes, size_t size, off64_t place)
  {
    return pwrite(descriptor, bytes, size, place);
  }

  int fsync(int descriptor)
  {
    return faulty_sync(descriptor);
  }

  int fdatasync(int descriptor)
  {
    return faulty_sync(descriptor);
  }

  int close(int descriptor)
  {
    const bool fails =
      descriptor >= 0 && is_inside(descriptor) && fate(Needs::nothing) == Fate::error;
    const int result =
      static_cast<int>(::syscall(SYS_close, descriptor)); // it is closed all the same
    return fails ? fail() : result;
  }

  int ftruncate(int descriptor, off_t size) noexcept
  {
    return is_inside(descriptor) && fate(Needs::nothing) == Fate::error
      ? fail()
      : static_cast<int>(::syscall(SYS_ftruncate, descriptor, size));
  }

  int ftruncate64(int descriptor, off64_t size) noexcept
  {
    return ftruncate(descriptor, size);
  }

  int rename(const char* from, const char* to) noexcept
  {
    return names_inside(to) && fate(Needs::nothing) == Fate::error
      ? fail()
      : static_cast<int>(::syscall(SYS_rename, from, to));
  }

  int mkdir(const char* name, mode_t mode) noexcept
  {
    return names_inside(name) && fate(Needs::room) == Fate::error
      ? fail()
      : static_cast<int>(::syscall(SYS_mkdir, name, mode));
  }

  int unlink(const char* name) noexcept
  {
    return names_inside(name) && fate(Needs::nothing) == Fate::error
      ? fail()
      : static_cast<int>(::syscall(SYS_unlink, name));
  }

  int rmdir(const char* name) noexcept
  {
    return names_inside(name) && fate(Needs::nothing) == Fate::error
      ? fail()
      : static_cast<int>(::syscall(SYS_rmdir, name));
  }

  int remove(const char* name) noexcept
  {
    if (names_inside(name) && fate(Needs::nothing) == Fate::error)
    {
      return fail();
    }
    const int result = static_cast<int>(::syscall(SYS_unlink, name));
    return result != 0 && errno == EISDIR ? static_cast<int>(::syscall(SYS_rmdir, name)) : result;
  }
}
