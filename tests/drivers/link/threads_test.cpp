#include <thread>

#include "tests/drivers/link/running.hpp"

/// The two ends of a link inside the process may be on two threads.
namespace drydock::link::testing {
namespace {

Task<void> echo(ByteLink& link, std::size_t size) {
  Buffer buffer(512);
  for (std::size_t done = 0; done < size;) {
    const auto received = co_await link.read(buffer);
    if (!received) co_return received.error();
    const auto written = co_await link.write(std::span(buffer).first(received->size));
    if (!written) co_return written.error();
    done += received->size;
  }
  co_return boost::system::result<void>{};
}

TEST(Threads, AMemoryLineCarriesBytesBetweenThem) {
  constexpr std::size_t size = 200'000;
  asio::io_context here, there;
  const auto device = open(there, "memory:threads", Side::device);
  const auto driver = open(here, "memory:threads", Side::driver);
  std::thread other([&] { EXPECT_TRUE(run(there, echo(*device, size))); });
  Buffer sent(size);
  for (std::size_t i = 0; i < size; ++i) sent[i] = static_cast<std::uint8_t>(i * 7);
  const auto writing = start(here, driver->write(sent));
  EXPECT_EQ(run(here, read_bytes(*driver, size)).value(), sent);
  EXPECT_TRUE(writing->outcome && *writing->outcome);
  other.join();
}

Task<void> send_many(FrameLink& bus, unsigned count) {
  for (unsigned i = 0; i < count; ++i) {
    wire::CanFrame frame;
    frame.id = i;
    const auto written = co_await bus.write(frame);
    if (!written) co_return written.error();
  }
  co_return boost::system::result<void>{};
}

TEST(Threads, AMemoryBusCarriesFramesBetweenThem) {
  constexpr unsigned count = 1000;  // fewer than the queue of a member holds
  asio::io_context here, there;
  const auto device = open_bus(there, "memory-can:threads", Side::device);
  const auto driver = open_bus(here, "memory-can:threads", Side::driver);
  std::thread other([&] { EXPECT_TRUE(run(there, send_many(*device, count))); });
  for (unsigned i = 0; i < count; ++i) {
    const auto received = run(here, driver->read());
    ASSERT_TRUE(received) << i;
    EXPECT_EQ(received->frame.id, i);
  }
  other.join();
  EXPECT_EQ(driver->dropped(), 0U);
}

}  // namespace
}  // namespace drydock::link::testing
