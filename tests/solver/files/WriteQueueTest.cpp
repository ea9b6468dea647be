#include "solver/files/WriteQueue.h"

#include "solver/Errors.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <memory>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

namespace vesicle::test
{
namespace
{

/// A piece of work that is under way until it is let go.
class Gate
{
public:
  std::function<void()> piece()
  {
    return [this]
    {
      reached_.set_value();
      open_.get_future().wait();
    };
  }
  void await() { reached_.get_future().wait(); }
  void open() { open_.set_value(); }

private:
  std::promise<void> reached_, open_;
};

[[noreturn]] void fail()
{
  throw IoError("file: can't be written: No space left on device");
}

std::string message_of(const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const IoError& error)
  {
    return error.what();
  }
  return "";
}

}

TEST(WriteQueue, DoesAllInOrderOnOneThreadOfItsOwn)
{
  std::vector<int> done, in_order(1000);
  std::iota(in_order.begin(), in_order.end(), 0);
  std::vector<std::thread::id> threads;
  WriteQueue queue(3);
  for (const int i : in_order)
  {
    queue.add(
      [&, i]
      {
        done.push_back(i);
        threads.push_back(std::this_thread::get_id());
      });
  }
  queue.wait();
  EXPECT_EQ(done, in_order);
  EXPECT_NE(threads.front(), std::this_thread::get_id());
  EXPECT_EQ(threads, std::vector<std::thread::id>(in_order.size(), threads.front()));
}

TEST(WriteQueue, GoesOnWhileAPieceIsUnderWay)
{
  Gate gate;
  std::atomic<bool> done = false;
  WriteQueue queue(2);
  queue.add(gate.piece());
  queue.add([&] { done = true; });
  gate.await();
  EXPECT_FALSE(done);
  gate.open();
  queue.wait();
  EXPECT_TRUE(done);
}

// Of 2 pieces at most: the third is taken when the first is done, and not before.
TEST(WriteQueue, HoldsNoMoreThanItsCapacity)
{
  Gate gate;
  std::atomic<int> taken = 0;
  WriteQueue queue(2);
  queue.add(gate.piece());
  queue.add([] {});
  gate.await();
  std::jthread owner(
    [&]
    {
      queue.add([] {});
      ++taken;
    });
  std::this_thread::sleep_for(std::chrono::milliseconds(20)); // a wrong queue has taken it by then
  EXPECT_EQ(taken, 0);
  gate.open();
  owner.join();
  EXPECT_EQ(taken, 1);
}

TEST(WriteQueue, AFailureIsTheLastThingDoneAndToldFromThenOn)
{
  Gate gate;
  int done = 0;
  WriteQueue queue(4);
  queue.add([&] { ++done; });
  queue.add(gate.piece());
  queue.add(fail);
  queue.add([&] { ++done; });
  gate.open();
  const std::string told = "file: can't be written: No space left on device";
  EXPECT_EQ(message_of([&] { queue.wait(); }), told);
  EXPECT_EQ(message_of([&] { queue.add([&] { ++done; }); }), told);
  EXPECT_EQ(message_of([&] { queue.wait(); }), told);
  EXPECT_EQ(done, 1);
}

TEST(WriteQueue, AFailureFreesWhoWaitsForRoom)
{
  Gate gate;
  WriteQueue queue(1);
  queue.add(
    [&]
    {
      gate.piece()();
      fail();
    });
  gate.await();
  auto waiting =
    std::async(std::launch::async, [&] { return message_of([&] { queue.add([] {}); }); });
  gate.open();
  EXPECT_NE(waiting.get(), "");
}

TEST(WriteQueue, EndsWhenAllIsDone)
{
  int done = 0;
  {
    WriteQueue queue(10);
    for (int i = 0; i < 10; ++i)
    {
      queue.add([&] { ++done; });
    }
  }
  EXPECT_EQ(done, 10);
}

TEST(WriteQueue, KeepsNothingOfWhatIsDone)
{
  const auto owned = std::make_shared<int>();
  WriteQueue queue(1);
  queue.add([owned] {});
  queue.wait();
  EXPECT_EQ(owned.use_count(), 1);
}

}
