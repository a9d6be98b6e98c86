#include "drivers/io/signal.hpp"

#include <gtest/gtest.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>

namespace signal_test {

using drydock::io::Signal;
using drydock::measurement::Stamp;
using std::chrono::hours;
using Deadline = std::optional<Stamp>;

/// Coroutines that wait for one signal; counts those that woke.
struct Waiters {
  boost::asio::io_context io;
  std::shared_ptr<Signal> signal = std::make_shared<Signal>(io.get_executor());
  int woken = 0;

  void wait(Deadline deadline = {}, Stamp now = {}) {
    boost::asio::co_spawn(io, waiting(deadline, now), boost::asio::detached);
    io.poll();
  }
  boost::asio::awaitable<void> waiting(Deadline deadline, Stamp now) {
    if (deadline)
      co_await signal->wait_until(deadline, now);
    else
      co_await signal->wait();
    ++woken;
  }
};

TEST(Signal, WakesAllThatWait) {
  Waiters waiters;
  waiters.wait();
  waiters.wait();
  EXPECT_EQ(waiters.woken, 0);
  waiters.signal->notify();
  waiters.io.poll();
  EXPECT_EQ(waiters.woken, 2);
}

// The waiter has tested its condition but has not yet suspended when the condition changes.
TEST(Signal, WakesAWaiterThatIsAboutToSuspend) {
  Waiters waiters;
  boost::asio::co_spawn(
      waiters.io,
      [&]() -> boost::asio::awaitable<void> {
        waiters.signal->notify();
        co_await waiters.waiting({}, {});
      },
      boost::asio::detached);
  waiters.io.poll();
  EXPECT_EQ(waiters.woken, 1);
}

TEST(Signal, WakesAtOnceIfTheDeadlineHasPassed) {
  Waiters waiters;
  waiters.wait(Stamp{hours{1}}, Stamp{hours{2}});
  waiters.io.run();
  EXPECT_EQ(waiters.woken, 1);
}

TEST(Signal, WakesBeforeTheDeadlineWhenItIsNotified) {
  Waiters waiters;
  waiters.wait(Stamp{hours{2}}, Stamp{hours{1}});
  EXPECT_EQ(waiters.woken, 0);
  waiters.signal->notify();
  waiters.io.poll();
  EXPECT_EQ(waiters.woken, 1);
}

TEST(Signal, ForgetsAnOldDeadline) {
  Waiters waiters;
  waiters.wait(Stamp{hours{1}}, Stamp{hours{2}});
  waiters.io.run();
  waiters.io.restart();
  waiters.wait();
  EXPECT_EQ(waiters.woken, 1);
  waiters.signal->notify();
  waiters.io.poll();
  EXPECT_EQ(waiters.woken, 2);
}

}  // namespace signal_test
