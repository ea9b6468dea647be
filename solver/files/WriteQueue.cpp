#include "solver/files/WriteQueue.h"

#include <utility>

namespace vesicle
{

WriteQueue::WriteQueue(std::size_t capacity) : capacity_(capacity), thread_([this] { work(); }) {}

WriteQueue::~WriteQueue()
{
  const Lock lock(mutex_);
  closing_ = true;
  changed_.notify_all();
}

void WriteQueue::require_success() const
{
  if (failure_)
  {
    std::rethrow_exception(failure_);
  }
}

void WriteQueue::add(std::function<void()> piece)
{
  Lock lock(mutex_);
  changed_.wait(lock, [this] { return pieces_.size() < capacity_; });
  require_success();
  pieces_.push_back(std::move(piece));
  changed_.notify_all();
}

void WriteQueue::wait()
{
  Lock lock(mutex_);
  changed_.wait(lock, [this] { return pieces_.empty(); });
  require_success();
}

void WriteQueue::work()
{
  Lock lock(mutex_);
  for (;;)
  {
    changed_.wait(lock, [this] { return closing_ || !pieces_.empty(); });
    if (pieces_.empty())
    {
      return;
    }
    do_next(lock);
  }
}

void WriteQueue::do_next(Lock& lock)
{
  auto piece = std::move(pieces_.front());
  lock.unlock();
  std::exception_ptr failure;
  try
  {
    piece();
  }
  catch (...)
  {
    failure = std::current_exception();
  }
  piece = nullptr; // what it owns goes on this thread
  lock.lock();
  if (failure)
  {
    failure_ = failure;
    pieces_.clear();
  }
  else
  {
    pieces_.pop_front();
  }
  changed_.notify_all();
}

}
