// A wall clock that is set back: preloaded into a program, each look at it tells an hour less than the
// one before. Clocks that only measure how long something takes go on.

#include <atomic>
#include <ctime>

#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

namespace
{

timespec set_back()
{
  static std::atomic<long> looks = 0;
  timespec now{};
  ::syscall(SYS_clock_gettime, CLOCK_REALTIME, &now);
  now.tv_sec -= 3600 * ++looks;
  return now;
}

}

extern "C"
{

  int clock_gettime(clockid_t clock, timespec* now) noexcept
  {
    if (clock != CLOCK_REALTIME && clock != CLOCK_REALTIME_COARSE)
    {
      return static_cast<int>(::syscall(SYS_clock_gettime, clock, now));
    }
    *now = set_back();
    return 0;
  }

  int gettimeofday(timeval* now, void*) noexcept
  {
    const timespec time = set_back();
    *now = { time.tv_sec, time.tv_nsec / 1000 };
    return 0;
  }

  time_t time(time_t* now) noexcept
  {
    const time_t seconds = set_back().tv_sec;
    if (now)
    {
      *now = seconds;
    }
    return seconds;
  }
}
