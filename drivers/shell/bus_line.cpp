#include "drivers/shell/bus_line.hpp"

#include <boost/asio/awaitable.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <utility>

namespace drydock::shell {

namespace {
constexpr std::size_t most_frames_queued = 64;
}

boost::system::result<measurement::Provenance, link::OpenError> BusLine::open_link() {
  auto opened = link::open_frames(executor(), uri(), link::Side::driver);
  if (!opened) return opened.error();
  link_ = std::move(*opened);
  queued_.clear();
  return link_->provenance();
}

Line::Run BusLine::read_until_lost() {
  for (;;) {
    const auto received = co_await link_->read();
    if (!received) {
      lost(received.error());
      co_return;
    }
    if (received->own) continue;  // it was tapped when it was written
    follow_clock();
    tap(Direction::received, received->frame, received->at);
    const std::uint64_t dropped = link_->dropped();
    for (device::Device* device : devices()) {
      device->note_dropped(dropped);
      device->receive(received->frame, received->at);
    }
    rearm();
  }
}

Line::Run BusLine::write_until_lost() {
  while (is_open()) {
    if (queued_.empty()) {
      co_await writer_woken();
      continue;
    }
    std::swap(queued_, writing_);
    for (const wire::CanFrame& frame : writing_) {
      const auto written = co_await link_->write(frame);
      if (!written) {
        lost(written.error());
        break;
      }
      tap(Direction::sent, frame, link::now());
    }
    writing_.clear();
  }
}

void BusLine::send(const wire::CanFrame& frame) {
  if (!is_open() || queued_.size() >= most_frames_queued) return;
  queued_.push_back(frame);
  wake_writer();
}

}  // namespace drydock::shell
