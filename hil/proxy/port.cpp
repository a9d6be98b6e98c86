#include "hil/proxy/port.hpp"

#include <boost/asio/error.hpp>
#include <functional>

#include "drivers/link/clock.hpp"
#include "drivers/link/reading.hpp"

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

/// open() only begins a TCP connection. This waits for its result.
link::Task<void> connected(link::ByteLink& link, const link::Uri& uri) {
  if (uri.scheme == link::Scheme::tcp) co_return co_await link.write({});
  co_return boost::system::result<void>{};
}

link::Task<void> connected(link::FrameLink&, const link::Uri&) {
  co_return boost::system::result<void>{};
}

}  // namespace

template <class Link>
Port<Link>::Port(asio::io_context& io, link::Uri uri, link::Side side, Events events)
    : io_(io),
      uri_(std::move(uri)),
      side_(side),
      events_(std::move(events)),
      life_(life_of_a_port()),
      wake_(std::make_shared<io::Signal>(io.get_executor())) {}

template <class Link>
typename Port<Link>::Run Port<Link>::serve() {
  while (!finished_) {
    if (!wanted_) {
      tell(life_.stop(link::steady_now()));
      co_await wake_->wait();
      continue;
    }
    life_.start(link::steady_now());
    auto opened = link::Traffic<Link>::open(io_.get_executor(), uri_, side_);
    if (opened)
      co_await use(std::move(*opened));
    else
      tell(life_.open_failed(link::steady_now(), opened.error().message));
    while (wanted_ && life_.deadline() && link::steady_now() < *life_.deadline())
      co_await wake_->wait_until(life_.deadline(), link::steady_now());
    life_.tick(link::steady_now());
  }
}

template <class Link>
typename Port<Link>::Run Port<Link>::use(std::unique_ptr<Link> opened) {
  pump_.emplace(io_.get_executor(), *opened, longest_queue, std::bind_front(&Port::written, this));
  closed_ = false;
  const auto ready = co_await connected(*opened, uri_);
  if (ready && is_open()) {
    tell(life_.opened(link::steady_now()));
    const auto end =
        co_await link::relay_until_lost<Link>(*opened, std::bind_front(&Port::receive, this));
    lose(end.message());
  }
  while (pump_->is_writing()) co_await wake_->wait();
  pump_.reset();
  opened.reset();
  if (closed_) {
    tell(life_.stop(link::steady_now()));
  } else if (!ready) {
    tell(life_.open_failed(link::steady_now(), ready.error().message()));
  }
  tell(life_.link_lost(link::steady_now(), why_lost_.view()));
}

template <class Link>
typename Port<Link>::Run Port<Link>::receive(const Item& item, Stamp) {
  const Stamp at = link::steady_now();
  life_.message(at);
  counters_.received += link::Traffic<Link>::size_of(item);
  return events_.received(item, at);
}

template <class Link>
void Port<Link>::put(const Item& item) {
  if (is_open() && !pump_->put(item)) counters_.lost += link::Traffic<Link>::size_of(item);
}

template <class Link>
typename Port<Link>::Run Port<Link>::drain() {
  if (!pump_) co_return;
  co_await pump_->drain();
  if (!is_open()) wake_->notify();
}

template <class Link>
bool Port<Link>::written(const Item& item, const boost::system::error_code& failure) {
  constexpr bool is_bus = std::is_same_v<Link, link::FrameLink>;
  if (!failure)
    counters_.sent += link::Traffic<Link>::size_of(item);
  else if (is_bus && failure == asio::error::operation_not_supported)
    ++counters_.lost;  // slcan cannot carry error frames
  else
    lose(failure.message());
  return is_open();
}

/// The first caller gives the reason; then reading ends too.
template <class Link>
void Port<Link>::lose(std::string_view reason) {
  if (!is_open()) return;
  why_lost_ = device::Reason{reason};
  pump_->close();
}

template <class Link>
void Port<Link>::want(bool wanted) {
  wanted_ = wanted;
  if (!wanted && is_open()) {
    closed_ = true;
    lose("closed");
  }
  wake_->notify();
}

template <class Link>
void Port<Link>::finish() {
  finished_ = true;
  want(false);
}

template class Port<link::ByteLink>;
template class Port<link::FrameLink>;

}  // namespace drydock::proxy
