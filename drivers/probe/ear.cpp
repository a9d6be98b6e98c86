#include "drivers/probe/ear.hpp"

#include <array>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <vector>

namespace drydock::probe {
namespace {

namespace asio = boost::asio;

constexpr std::chrono::milliseconds idle_period{100};

}  // namespace

/// `read() -> awaitable<bool>` takes one reading. False ends the listening.
template <class Link, class Read, class Idle>
void Ear::run(Link& link, link::Stamp until, Read read, const Idle& idle) {
  trouble_.clear();
  io_.restart();
  bool enough = false, ended = false;
  asio::co_spawn(
      io_,
      [&]() -> asio::awaitable<void> {
        while (co_await read()) {
        }
        ended = true;
      },
      asio::detached);
  asio::steady_timer timer(io_);
  std::function<void()> wait = [&] {
    timer.expires_after(idle_period);
    timer.async_wait([&](const boost::system::error_code& ec) {
      if (ec) return;
      enough = idle();
      wait();
    });
  };
  wait();
  while (!enough && !ended && !interrupted() && link::now() < until) io_.run_one();
  timer.cancel();
  wait = [] {};
  link.close();
  while (!ended || talking_ > 0) io_.run_one();  // the reader and the writers must release the link
  io_.poll();
}

void Ear::listen(link::ByteLink& line, link::Stamp until, const OnBytes& on_bytes) {
  std::array<std::uint8_t, 4096> buffer;
  const auto read = [&]() -> asio::awaitable<bool> {
    const auto got = co_await line.read(buffer);
    if (got) co_return !on_bytes({buffer.data(), got->size}, got->at);
    if (got.error() != asio::error::operation_aborted) trouble_ = got.error().message();
    co_return false;
  };
  run(line, until, read, [&] { return on_bytes({}, link::now()); });
}

void Ear::listen(link::FrameLink& bus, link::Stamp until, const OnFrame& on_frame) {
  const auto read = [&]() -> asio::awaitable<bool> {
    const auto got = co_await bus.read();
    if (got) co_return !on_frame(&*got);
    if (got.error() != asio::error::operation_aborted) trouble_ = got.error().message();
    co_return false;
  };
  run(bus, until, read, [&] { return on_frame(nullptr); });
}

void Ear::say(link::ByteLink& line, std::vector<std::uint8_t> bytes) {
  ++talking_;
  asio::co_spawn(
      io_,
      [this, &line, bytes = std::move(bytes)]() -> asio::awaitable<void> {
        (void)co_await line.write(bytes);
        --talking_;
      },
      asio::detached);
}

void Ear::say(link::FrameLink& bus, const wire::CanFrame& frame) {
  ++talking_;
  asio::co_spawn(
      io_,
      [this, &bus, frame]() -> asio::awaitable<void> {
        (void)co_await bus.write(frame);
        --talking_;
      },
      asio::detached);
}

}  // namespace drydock::probe
