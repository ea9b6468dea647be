#pragma once
// Loops whose iterations share nothing: the only place where the solver starts threads to compute.
// Those that wait for a disk are WriteQueue's.

#ifdef __has_feature
#if __has_feature(thread_sanitizer)
#define VESICLE_THREAD_SANITIZER
#endif
#endif
#if defined(__SANITIZE_THREAD__) || defined(VESICLE_THREAD_SANITIZER)
#include <array>
#include <exception>
#include <thread>
#else
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#include <functional>
#include <initializer_list>

namespace vesicle
{

/// Calls body(0) to body(count − 1), in no order, on the threads of oneTBB, which are VTK's too, and
/// returns when all are done. The body writes to what belongs to its own index alone, so that
/// results don't depend on the threads. At least `grain` successive calls stay on one thread: some
/// ten thousand operations are worth a task. An exception of the body's is passed on.
#if defined(__SANITIZE_THREAD__) || defined(VESICLE_THREAD_SANITIZER)
/// The thread sanitizer understands the system's threads, but nothing that Debian's oneTBB
/// synchronises, since that isn't built with it.
template<typename Index, typename Body>
void parallel_for(Index count, const Body& body, Index = 1)
{
  constexpr int threads = 4;
  std::array<std::exception_ptr, threads> failures;
  {
    std::array<std::jthread, threads> running;
    for (int t = 0; t < threads; ++t)
      running[t] = std::jthread(
        [&, t]
        {
          try
          {
            for (Index i = count * t / threads; i < count * (t + 1) / threads; ++i)
              body(i);
          }
          catch (...)
          {
            failures[t] = std::current_exception();
          }
        });
  }
  for (const std::exception_ptr& failure : failures)
    if (failure)
      std::rethrow_exception(failure);
}
#else
template<typename Index, typename Body>
void parallel_for(Index count, const Body& body, Index grain = 1)
{
  tbb::parallel_for(tbb::blocked_range<Index>(0, count, grain),
    [&](const tbb::blocked_range<Index>& block)
    {
      for (Index i = block.begin(); i < block.end(); ++i)
        body(i);
    });
}
#endif

/// The tasks, which share nothing, side by side; returns when all are done.
inline void run_together(std::initializer_list<std::function<void()>> tasks)
{
  parallel_for(tasks.size(), [&](std::size_t i) { tasks.begin()[i](); });
}

}
