#include "drivers/link/pump.hpp"

#include <boost/asio/detached.hpp>
#include <boost/asio/error.hpp>

#include "tests/drivers/link/running.hpp"

namespace pump_test {

using namespace drydock::link;
using namespace drydock::link::testing;
using drydock::measurement::Provenance;
using drydock::wire::CanFrame;
using Failure = boost::system::error_code;

std::string text_of(drydock::wire::Bytes bytes) { return {bytes.begin(), bytes.end()}; }
std::string text_of(const CanFrame& frame) { return std::to_string(frame.id); }

/// Keeps what is written. While it is held, a write does not end.
class Wire {
 public:
  explicit Wire(asio::io_context& io)
      : changed_(std::make_shared<drydock::io::Signal>(io.get_executor())) {}

  Task<void> take(std::string text) {
    while (held && !closed) co_await changed_->wait();
    if (closed) co_return Failure(asio::error::operation_aborted);
    if (failure) co_return failure;
    written.push_back(std::move(text));
    co_return boost::system::result<void>{};
  }
  void release() {
    held = false;
    changed_->notify();
  }
  void shut() {
    closed = true;
    changed_->notify();
  }

  bool held = false, closed = false;
  Failure failure;
  std::vector<std::string> written;

 private:
  std::shared_ptr<drydock::io::Signal> changed_;
};

struct Line final : ByteLink, Wire {
  using Wire::Wire;
  Task<ReceivedBytes> read(std::span<std::uint8_t>) override {
    co_return Failure(asio::error::eof);
  }
  Task<void> write(std::span<const std::uint8_t> bytes) override { return take(text_of(bytes)); }
  void close() override { shut(); }
  Provenance provenance() const override { return Provenance::emulated; }
};

struct Bus final : FrameLink, Wire {
  using Wire::Wire;
  Task<ReceivedFrame> read() override { co_return Failure(asio::error::eof); }
  Task<void> write(const CanFrame& frame) override { return take(text_of(frame)); }
  void close() override { shut(); }
  Provenance provenance() const override { return Provenance::emulated; }
};

/// A pump on a link of the test. It counts failures and stops at the first, unless `goes_on`.
template <class Link, class Base, class Queue>
struct Pumping {
  static constexpr std::size_t most_queued = 4;

  asio::io_context io;
  Link link{io};
  int failures = 0;
  bool goes_on = false;
  Pump<Base, Queue> pump{io.get_executor(), link, most_queued, [this](const auto&, Failure why) {
                           failures += why ? 1 : 0;
                           return !why || goes_on;
                         }};

  void spawn(asio::awaitable<void> run) {
    asio::co_spawn(io, std::move(run), asio::detached);
    io.restart();
    io.poll();
  }
  void poll() {
    io.restart();
    io.poll();
  }
};

using Stream = Pumping<Line, ByteLink, Traffic<ByteLink>::Queue>;
using Messages = Pumping<Line, ByteLink, MessageQueue>;
using Frames = Pumping<Bus, FrameLink, Traffic<FrameLink>::Queue>;
using Texts = std::vector<std::string>;

CanFrame frame(std::uint32_t id) {
  CanFrame made;
  made.id = id;
  return made;
}

TEST(Pump, WritesTheBytesThatWaitAtOnce) {
  Stream s;
  EXPECT_TRUE(s.pump.put(bytes("ab")));
  EXPECT_TRUE(s.pump.put(bytes("cd")));
  s.spawn(s.pump.drain());
  EXPECT_EQ(s.link.written, Texts{"abcd"});
}

TEST(Pump, KeepsMessagesApart) {
  Messages s;
  s.pump.put(bytes("first"));
  s.pump.put(bytes("second"));
  s.spawn(s.pump.drain());
  EXPECT_EQ(s.link.written, (Texts{"first", "second"}));
}

TEST(Pump, RefusesWhatTheQueueCannotHold) {
  Stream stream;
  EXPECT_TRUE(stream.pump.put(bytes("abc")));
  EXPECT_FALSE(stream.pump.put(bytes("de")));
  EXPECT_TRUE(stream.pump.put(bytes("f")));
  Frames frames;
  for (std::uint32_t i = 0; i < 4; ++i) EXPECT_TRUE(frames.pump.put(frame(i)));
  EXPECT_FALSE(frames.pump.put(frame(4)));
}

TEST(Pump, WritesWhatIsPutDuringAWriteAfterIt) {
  Frames s;
  s.link.held = true;
  s.pump.put(frame(1));
  s.spawn(s.pump.drain());
  EXPECT_TRUE(s.pump.is_writing());
  s.pump.put(frame(2));
  s.link.release();
  s.poll();
  EXPECT_EQ(s.link.written, (Texts{"1", "2"}));
  EXPECT_FALSE(s.pump.is_writing());
}

TEST(Pump, ASecondDrainEndsAtOnce) {
  Frames s;
  s.link.held = true;
  s.pump.put(frame(1));
  s.spawn(s.pump.drain());
  bool ended = false;
  asio::co_spawn(s.io, s.pump.drain(), [&](const std::exception_ptr&) { ended = true; });
  s.poll();
  EXPECT_TRUE(ended);
  EXPECT_TRUE(s.pump.is_writing());
}

TEST(Pump, DrainsWhateverIsPutUntilItIsClosed) {
  Frames s;
  bool ended = false;
  asio::co_spawn(s.io, s.pump.drain_until_closed(),
                 [&](const std::exception_ptr&) { ended = true; });
  for (std::uint32_t i = 0; i < 8; ++i) {
    s.pump.put(frame(i));
    s.poll();
    EXPECT_EQ(s.link.written.size(), i + 1);
  }
  EXPECT_FALSE(ended);
  s.pump.close();
  s.poll();
  EXPECT_TRUE(ended);
  EXPECT_TRUE(s.link.closed);
}

TEST(Pump, ClosingEndsAWriteThatDoesNotEnd) {
  Frames s;
  s.link.held = true;
  s.pump.put(frame(1));
  s.spawn(s.pump.drain_until_closed());
  s.pump.close();
  s.poll();
  EXPECT_FALSE(s.pump.is_writing());
  EXPECT_EQ(s.failures, 1);
  EXPECT_FALSE(s.pump.put(frame(2)));
}

TEST(Pump, AFailureClosesTheLink) {
  Frames s;
  s.link.failure = asio::error::broken_pipe;
  s.pump.put(frame(1));
  s.pump.put(frame(2));
  s.spawn(s.pump.drain());
  EXPECT_EQ(s.failures, 1);
  EXPECT_TRUE(s.link.closed);
  EXPECT_FALSE(s.pump.is_open());
}

TEST(Pump, GoesOnAfterAFailureIfItsOwnerWantsThat) {
  Frames s;
  s.goes_on = true;
  s.link.failure = asio::error::operation_not_supported;
  s.pump.put(frame(1));
  s.pump.put(frame(2));
  s.spawn(s.pump.drain());
  EXPECT_EQ(s.failures, 2);
  s.link.failure = {};
  s.pump.put(frame(3));
  s.spawn(s.pump.drain());
  EXPECT_EQ(s.link.written, Texts{"3"});
}

}  // namespace pump_test
