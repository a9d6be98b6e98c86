#include "drivers/probe/ear.hpp"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>

#include "drivers/link/clock.hpp"
#include "drivers/link/reading.hpp"

namespace drydock::probe {
namespace {

namespace asio = boost::asio;

constexpr std::chrono::milliseconds idle_period{100};

}  // namespace

/// `on_read(item, at) -> bool` and `on_idle() -> bool`: true if enough was heard.
template <class Link, class OnRead, class OnIdle>
void Ear::run(Link& link, link::Stamp until, const OnRead& on_read, const OnIdle& on_idle) {
  failure_.clear();
  io_.restart();
  bool enough = false, ended = false, closed = false;
  asio::co_spawn(io_,
                 link::read_until_lost<Link>(link,
                                             [&](const auto& item, link::Stamp) {
                                               if (!enough)
                                                 enough = on_read(item, link::steady_now());
                                             }),
                 [&](const std::exception_ptr&, const boost::system::error_code& why) {
                   ended = true;
                   if (!closed && why != asio::error::operation_aborted) failure_ = why;
                 });
  asio::steady_timer timer(io_);
  std::function<void()> wait = [&] {
    timer.expires_after(idle_period);
    timer.async_wait([&](const boost::system::error_code& ec) {
      if (ec) return;
      enough = enough || on_idle();
      wait();
    });
  };
  wait();
  while (!enough && !ended && !interrupted() && link::steady_now() < until) io_.run_one();
  timer.cancel();
  wait = [] {};
  closed = true;
  link.close();
  while (!ended || talking_ > 0) io_.run_one();  // the reader and the writers must release the link
  io_.poll();
}

void Ear::listen(link::ByteLink& line, link::Stamp until, const OnBytes& on_bytes) {
  run(line, until, on_bytes, [&] { return on_bytes({}, link::steady_now()); });
}

void Ear::listen(link::FrameLink& bus, link::Stamp until, const OnFrame& on_frame) {
  const auto on_read = [&](const wire::CanFrame& frame, link::Stamp at) {
    return on_frame(&frame, at);
  };
  run(bus, until, on_read, [&] { return on_frame(nullptr, link::steady_now()); });
}

template <class Link, class Content>
void Ear::write(Link& link, Content content) {
  ++talking_;
  asio::co_spawn(
      io_,
      [this, &link, content = std::move(content)]() -> asio::awaitable<void> {
        (void)co_await link.write(content);
        --talking_;
      },
      asio::detached);
}

void Ear::say(link::ByteLink& line, std::vector<std::uint8_t> bytes) {
  write(line, std::move(bytes));
}

void Ear::say(link::FrameLink& bus, const wire::CanFrame& frame) { write(bus, frame); }

}  // namespace drydock::probe
