#include "drivers/shell/linked_line.hpp"

#include <boost/asio/experimental/awaitable_operators.hpp>
#include <functional>
#include <utility>

#include "drivers/link/reading.hpp"

namespace drydock::shell {

namespace {

/// No driver sends this much at once. The limit keeps the queue finite if the link accepts nothing
/// more.
template <class Link>
constexpr std::size_t most_queued = 0;
template <>
constexpr std::size_t most_queued<link::ByteLink> = 4096;
template <>
constexpr std::size_t most_queued<link::FrameLink> = 64;

}  // namespace

template <class Link>
typename LinkedLine<Link>::Opened LinkedLine<Link>::open(const link::Uri& uri) {
  return link::Traffic<Link>::open(executor(), uri, link::Side::driver);
}

template <class Link>
boost::system::result<measurement::Provenance, link::OpenError> LinkedLine<Link>::open_link() {
  auto opened = open(next_uri());
  if (!opened) return opened.error();
  link_ = std::move(*opened);
  pump_.emplace(executor(), *link_, most_queued<Link>, std::bind_front(&LinkedLine::written, this));
  return link_->provenance();
}

template <class Link>
Line::Run LinkedLine<Link>::serve_link() {
  using namespace boost::asio::experimental::awaitable_operators;
  co_await (read_until_lost() && pump_->drain_until_closed());
}

template <class Link>
Line::Run LinkedLine<Link>::read_until_lost() {
  lost(co_await link::read_until_lost<Link>(*link_, std::bind_front(&LinkedLine::heard, this)));
}

template <class Link>
void LinkedLine<Link>::heard(const Item& item, Stamp at) {
  follow_clock();
  tap(Direction::received, item, at);
  receive(item, at);
  rearm();
}

template <class Link>
void LinkedLine<Link>::destroy_link() {
  pump_.reset();
  link_.reset();
}

template <class Link>
void LinkedLine<Link>::put(const Item& item) {
  if (is_open()) pump_->put(item);
}

template <class Link>
bool LinkedLine<Link>::written(const Item& item, const boost::system::error_code& failure) {
  if (failure)
    lost(failure);
  else
    tap(Direction::sent, item, link::now());
  return !failure;
}

template class LinkedLine<link::ByteLink>;
template class LinkedLine<link::FrameLink>;

}  // namespace drydock::shell
