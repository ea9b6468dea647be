#pragma once
// Files written while the program goes on: pieces of work for a thread of their own, in order.

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace vesicle
{

/// Does what it is handed, one piece after the other, on one thread that waits for the disk in the
/// place of who computes. Pieces own what they write, or it is nobody else's until wait(). One that
/// throws is the last one done: all calls from then on throw what it threw, so that nothing is
/// written behind a gap.
class WriteQueue
{
public:
  /// `capacity`: how many pieces there may be at a time, the one under way among them, 1 or more.
  explicit WriteQueue(std::size_t capacity);
  /// Returns when all is done, or one has failed; that failure is then lost, unlike by wait().
  ~WriteQueue();
  WriteQueue(const WriteQueue&) = delete;
  WriteQueue& operator=(const WriteQueue&) = delete;

  /// Hands over a piece; waits while there are `capacity` already.
  void add(std::function<void()> piece);
  /// Returns when all is done.
  void wait();

private:
  using Lock = std::unique_lock<std::mutex>;

  void work();
  void do_next(Lock& lock);
  void require_success() const;

  std::size_t capacity_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> pieces_; ///< the first is under way
  std::exception_ptr failure_;
  bool closing_ = false;
  std::jthread thread_;
};

}
