#include "drivers/link/reading.hpp"

#include <boost/asio/error.hpp>

#include "drivers/io/signal.hpp"
#include "tests/drivers/link/running.hpp"

namespace reading_test {

using namespace drydock::link;
using namespace drydock::link::testing;
using drydock::wire::CanFrame;
using Failure = boost::system::error_code;

/// Frames to read; after the last one the bus is gone.
struct Script final : FrameLink {
  explicit Script(std::vector<ReceivedFrame> frames) : frames_(std::move(frames)) {}
  Task<ReceivedFrame> read() override {
    if (next_ == frames_.size()) co_return Failure(asio::error::network_down);
    co_return frames_[next_++];
  }
  Task<void> write(const CanFrame&) override { co_return boost::system::result<void>{}; }
  void close() override {}
  drydock::measurement::Provenance provenance() const override {
    return drydock::measurement::Provenance::emulated;
  }

 private:
  std::vector<ReceivedFrame> frames_;
  std::size_t next_ = 0;
};

ReceivedFrame received(std::uint32_t id, bool own = false) {
  ReceivedFrame made{{}, Stamp{std::chrono::seconds{id}}, own};
  made.frame.id = id;
  return made;
}

TEST(Reading, GivesEveryFrameWithItsTimeThenTheReasonOfTheEnd) {
  asio::io_context io;
  Script bus({received(1), received(2)});
  std::vector<std::uint32_t> ids;
  Failure end;
  asio::co_spawn(io,
                 read_until_lost<FrameLink>(bus,
                                            [&](const CanFrame& frame, Stamp at) {
                                              ids.push_back(frame.id);
                                              EXPECT_EQ(at, Stamp{std::chrono::seconds{frame.id}});
                                            }),
                 [&](const std::exception_ptr&, Failure why) { end = why; });
  io.run();
  EXPECT_EQ(ids, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(end, asio::error::network_down);
}

TEST(Reading, LeavesOutEchoesOfOwnFrames) {
  asio::io_context io;
  Script bus({received(1, true), received(2)});
  std::vector<std::uint32_t> ids;
  asio::co_spawn(io,
                 read_until_lost<FrameLink>(
                     bus, [&](const CanFrame& frame, Stamp) { ids.push_back(frame.id); }),
                 [](const std::exception_ptr&, Failure) {});
  io.run();
  EXPECT_EQ(ids, std::vector<std::uint32_t>{2});
}

TEST(Reading, EndsWhenTheLinkIsClosed) {
  asio::io_context io;
  const auto device = open(io, "memory:reading", Side::device);
  const auto driver = open(io, "memory:reading", Side::driver);
  std::string heard;
  Failure end;
  asio::co_spawn(
      io,
      read_until_lost<ByteLink>(*driver, [&](drydock::wire::Bytes bytes,
                                             Stamp) { heard.append(bytes.begin(), bytes.end()); }),
      [&](const std::exception_ptr&, Failure why) { end = why; });
  ASSERT_TRUE(run(io, device->write(bytes("hello"))));
  ASSERT_TRUE(run_until(io, [&] { return heard.size() == 5; }));
  EXPECT_EQ(heard, "hello");
  EXPECT_FALSE(end);
  driver->close();
  ASSERT_TRUE(run_until(io, [&] { return end.failed(); }));
  EXPECT_EQ(end, asio::error::operation_aborted);
}

TEST(Reading, WaitsForTheRelayBeforeTheNextRead) {
  asio::io_context io;
  Script bus({received(1), received(2)});
  const auto passed_on = std::make_shared<drydock::io::Signal>(io.get_executor());
  std::vector<std::uint32_t> ids;
  asio::co_spawn(io,
                 relay_until_lost<FrameLink>(bus,
                                             [&](const CanFrame& frame, Stamp) {
                                               ids.push_back(frame.id);
                                               return passed_on->wait();
                                             }),
                 [](const std::exception_ptr&, Failure) {});
  io.poll();
  EXPECT_EQ(ids, std::vector<std::uint32_t>{1});
  passed_on->notify();
  io.poll();
  EXPECT_EQ(ids, (std::vector<std::uint32_t>{1, 2}));
  passed_on->notify();
  EXPECT_GT(io.run(), 0u);
}

}  // namespace reading_test
