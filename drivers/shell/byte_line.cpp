#include "drivers/shell/byte_line.hpp"

#include <boost/asio/awaitable.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <utility>

namespace drydock::shell {

namespace {
/// No driver sends this much at once. The limit keeps the queue finite if the line accepts no more
/// bytes.
constexpr std::size_t most_bytes_queued = 4096;
}  // namespace

boost::system::result<measurement::Provenance, link::OpenError> ByteLine::open_link() {
  auto opened = link::open_bytes(executor(), next_uri(), link::Side::driver);
  if (!opened) return opened.error();
  link_ = std::move(*opened);
  queued_.clear();
  return link_->provenance();
}

/// The URI for the next opening, with the rate that the search has reached.
link::Uri ByteLine::next_uri() {
  link::Uri next = uri();
  if (!searches_baud(next)) return next;
  std::uint64_t heard = 0;
  for (const device::Device* device : devices()) heard += device->messages();
  search_.open_again(heard > std::exchange(heard_before_, heard));
  next.query["baud"] = std::to_string(search_.baud());
  for (device::Device* device : devices()) device->set_baud(search_.baud());
  return next;
}

Line::Run ByteLine::read_until_lost() {
  for (;;) {
    const auto received = co_await link_->read(read_buffer_);
    if (!received) {
      lost(received.error());
      co_return;
    }
    const wire::Bytes bytes{read_buffer_.data(), received->size};
    follow_clock();
    tap(Direction::received, bytes, received->at);
    for (device::Device* device : devices()) device->receive(bytes, received->at);
    rearm();
  }
}

Line::Run ByteLine::write_until_lost() {
  while (is_open()) {
    if (queued_.empty()) {
      co_await writer_woken();
      continue;
    }
    std::swap(queued_, writing_);
    const auto written = co_await link_->write(writing_);
    if (written) tap(Direction::sent, writing_, link::now());
    writing_.clear();
    if (!written) lost(written.error());
  }
}

void ByteLine::send(wire::Bytes bytes) {
  if (!is_open() || queued_.size() + bytes.size() > most_bytes_queued) return;
  queued_.insert(queued_.end(), bytes.begin(), bytes.end());
  wake_writer();
}

}  // namespace drydock::shell
