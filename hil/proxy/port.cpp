#include "hil/proxy/port.hpp"

#include <array>
#include <boost/asio/as_tuple.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/use_awaitable.hpp>

namespace drydock::proxy {

namespace asio = boost::asio;

namespace {

/// Options for a driver-like port that waits until a cable is plugged in again. A silent device is
/// never reopened.
device::LifeCycleOptions life_of_a_port() {
  device::LifeCycleOptions options;
  options.stale_after = std::chrono::hours{24 * 365};  // silence concerns only the drivers
  options.reopen_when_quiet = false;
  return options;
}

/// Items that may wait for a side that does not read.
constexpr std::size_t longest_queue = 1 << 16;

link::Task<void> write_all(link::ByteLink& link, const std::vector<std::uint8_t>& bytes,
                           std::uint64_t&) {
  return link.write(bytes);
}

link::Task<void> write_all(link::FrameLink& link, const std::vector<wire::CanFrame>& frames,
                           std::uint64_t& lost) {
  for (const auto& frame : frames) {
    const auto written = co_await link.write(frame);
    if (written) continue;
    if (written.error() != asio::error::operation_not_supported) co_return written;
    ++lost;  // slcan cannot carry error frames
  }
  co_return boost::system::result<void>{};
}

/// open() only begins a TCP connection. This waits for its result.
link::Task<void> connected(link::ByteLink& link, const link::Uri& uri) {
  if (uri.scheme == link::Scheme::tcp) co_return co_await link.write({});
  co_return boost::system::result<void>{};
}

link::Task<void> connected(link::FrameLink&, const link::Uri&) {
  co_return boost::system::result<void>{};
}

std::size_t size_of(wire::Bytes bytes) { return bytes.size(); }
std::size_t size_of(const wire::CanFrame&) { return 1; }

}  // namespace

template <class Link>
Port<Link>::Port(asio::io_context& io, link::Uri uri, link::Side side, Events events)
    : io_(io),
      uri_(std::move(uri)),
      side_(side),
      events_(std::move(events)),
      life_(life_of_a_port()),
      wake_(io) {}

template <class Link>
typename Port<Link>::Run Port<Link>::serve() {
  while (!finished_) {
    if (!wanted_) {
      tell(life_.stop(link::now()));
      co_await wait();
      continue;
    }
    life_.start(link::now());
    auto opened = Traffic<Link>::open(io_.get_executor(), uri_, side_);
    if (opened)
      co_await use(std::move(*opened));
    else
      tell(life_.open_failed(link::now(), opened.error().message));
    while (wanted_ && life_.deadline() && link::now() < *life_.deadline())
      co_await wait(life_.deadline());
    life_.tick(link::now());
  }
}

template <class Link>
typename Port<Link>::Run Port<Link>::use(std::unique_ptr<Link> opened) {
  link_ = std::move(opened);
  lost_ = closed_ = false;
  const auto ready = co_await connected(*link_, uri_);
  if (ready && !lost_) {
    tell(life_.opened(link::now()));
    co_await read_until_lost();
  }
  while (is_writing_) co_await wait();
  link_.reset();
  queued_.clear();
  if (closed_) {
    tell(life_.stop(link::now()));
  } else if (!ready) {
    tell(life_.open_failed(link::now(), ready.error().message()));
  }
  tell(life_.link_lost(link::now(), why_lost_.view()));
}

template <class Link>
typename Port<Link>::Run Port<Link>::read_until_lost() {
  if constexpr (std::is_same_v<Link, link::ByteLink>) {
    std::array<std::uint8_t, 4096> buffer;
    for (;;) {
      const auto received = co_await link_->read(buffer);
      if (!received) co_return lose(received.error().message());
      life_.message(received->at);
      counters_.received += received->size;
      const wire::Bytes bytes{buffer.data(), received->size};
      co_await events_.received(bytes, received->at);
    }
  } else {
    for (;;) {
      const auto received = co_await link_->read();
      if (!received) co_return lose(received.error().message());
      if (received->own) continue;
      life_.message(received->at);
      ++counters_.received;
      co_await events_.received(received->frame, received->at);
    }
  }
}

template <class Link>
void Port<Link>::put(const Item& item) {
  if (!is_open()) return;
  if (queued_.size() >= longest_queue)
    counters_.lost += size_of(item);
  else
    Traffic<Link>::append(queued_, item);
}

template <class Link>
typename Port<Link>::Run Port<Link>::drain() {
  if (is_writing_) co_return;
  is_writing_ = true;
  while (is_open() && !queued_.empty()) {
    std::swap(queued_, writing_);
    const auto written = co_await write_all(*link_, writing_, counters_.lost);
    if (written)
      counters_.sent += writing_.size();
    else
      lose(written.error().message());
    writing_.clear();
  }
  is_writing_ = false;
  if (lost_) wake_.cancel();
}

/// The first caller gives the reason; then reading ends too.
template <class Link>
void Port<Link>::lose(std::string_view reason) {
  if (lost_) return;
  lost_ = true;
  why_lost_ = device::Reason{reason};
  link_->close();
}

template <class Link>
void Port<Link>::want(bool wanted) {
  wanted_ = wanted;
  if (!wanted && is_open()) {
    closed_ = true;
    lose("closed");
  }
  wake_.cancel();
}

template <class Link>
void Port<Link>::finish() {
  finished_ = true;
  want(false);
}

template <class Link>
typename Port<Link>::Run Port<Link>::wait(std::optional<Stamp> until) {
  if (until)
    wake_.expires_after(*until - link::now());
  else
    wake_.expires_at(asio::steady_timer::time_point::max());
  co_await wake_.async_wait(asio::as_tuple(asio::use_awaitable));
}

template class Port<link::ByteLink>;
template class Port<link::FrameLink>;

}  // namespace drydock::proxy
