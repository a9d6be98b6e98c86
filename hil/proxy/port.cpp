#include "hil/proxy/port.hpp"

#include <boost/asio/error.hpp>
#include <boost/asio/experimental/awaitable_operators.hpp>
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

/// What the link took and could not deliver. A bus counts what it could not receive instead.
std::uint64_t undelivered(const link::ByteLink& link) { return link.dropped(); }
std::uint64_t undelivered(const link::FrameLink&) { return 0; }

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
  link_ = opened.get();
  dropped_before_ = 0;
  closed_ = false;
  const auto ready = co_await connected(*opened, uri_);
  if (ready && is_open()) {
    using namespace asio::experimental::awaitable_operators;
    tell(life_.opened(link::steady_now()));
    co_await (read_until_lost(*opened) && pump_->drain_until_closed());
  }
  counters_.lost += pump_->waiting() + undelivered(*opened);
  counters_.sent -= undelivered(*opened);
  link_ = nullptr;
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
typename Port<Link>::Run Port<Link>::read_until_lost(Link& opened) {
  const auto end =
      co_await link::relay_until_lost<Link>(opened, std::bind_front(&Port::receive, this));
  lose(end.message());
}

template <class Link>
typename Port<Link>::Run Port<Link>::receive(const Item& item, Stamp) {
  const Stamp at = link::steady_now();
  life_.message(at);
  counters_.received += link::Traffic<Link>::size_of(item);
  return events_.received(item, at);
}

template <class Link>
void Port<Link>::put(const Item& item, std::optional<Stamp> read_at) {
  if (!is_open()) return;
  if (pump_->put(item)) {
    if (!waiting_since_) waiting_since_ = read_at;
    return;
  }
  counters_.lost += link::Traffic<Link>::size_of(item);
  note_losses();
}

/// Says it once, until the other side takes something again.
template <class Link>
void Port<Link>::note_losses() {
  if (std::exchange(taking_, false) && events_.takes_nothing) events_.takes_nothing();
}

template <class Link>
typename Port<Link>::Counters Port<Link>::counters() const {
  Counters all = counters_;
  if (!link_) return all;
  all.sent -= undelivered(*link_);
  all.lost += undelivered(*link_);
  return all;
}

template <class Link>
bool Port<Link>::written(const Item& item, const boost::system::error_code& failure) {
  constexpr bool is_bus = std::is_same_v<Link, link::FrameLink>;
  const std::size_t size = link::Traffic<Link>::size_of(item);
  if (failure) {
    counters_.lost += size;
    const bool cannot_carry = is_bus && failure == asio::error::operation_not_supported;
    if (!cannot_carry) lose(failure.message());  // slcan cannot carry error frames
    return is_open();
  }
  counters_.sent += size;
  const std::uint64_t dropped = undelivered(*link_);
  if (std::exchange(dropped_before_, dropped) < dropped)
    note_losses();
  else
    taking_ = true;
  if (const auto since = std::exchange(waiting_since_, {}); since && events_.written)
    events_.written(*since);
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
