#pragma once

#include <boost/asio/io_context.hpp>
#include <functional>
#include <memory>
#include <optional>

#include "drivers/device/life_cycle.hpp"
#include "drivers/link/pump.hpp"

namespace drydock::proxy {

using link::Stamp;

/// One side of a proxy. The link is opened while it is wanted, and opened again after a growing
/// pause when it was lost. It is read until it is lost, and written in order; a side that takes
/// nothing holds up no reading. Its times are of link::steady_now(). Everything runs on the thread
/// of the io_context.
template <class Link>
class Port {
 public:
  using Run = boost::asio::awaitable<void>;
  using Item = typename link::Traffic<Link>::Item;

  struct Events {
    std::function<Run(const Item&, Stamp)> received;
    std::function<void(const device::Transition&)> changed;  ///< opened, lost, or failed to open
    std::function<void(Stamp)> written;   ///< what was put with this time is on the link
    std::function<void()> takes_nothing;  ///< what is put is lost from now on
  };
  /// In bytes or frames.
  struct Counters {
    std::uint64_t received = 0, sent = 0;
    std::uint64_t lost = 0;  ///< not sent: an open side did not take it, or cannot carry it
  };

  Port(boost::asio::io_context& io, link::Uri uri, link::Side side, Events events);

  /// Runs until finish().
  Run serve();
  void finish();

  /// false closes the link. true right after false makes readers see an end, and they may come
  /// back.
  void want(bool wanted);

  /// Queues the item, which was read at this time. While the link is closed the item is lost, as on
  /// a wire.
  void put(const Item& item, std::optional<Stamp> read_at = {});

  bool is_open() const { return pump_ && pump_->is_open(); }
  /// Bytes or frames that were put and do not yet travel.
  std::size_t waiting() const { return pump_ ? pump_->waiting() : 0; }
  const link::Uri& uri() const { return uri_; }
  Counters counters() const;

 private:
  Run use(std::unique_ptr<Link> opened);  ///< until the link is lost or closed
  Run read_until_lost(Link& opened);
  Run receive(const Item& item, Stamp at);
  bool written(const Item& item, const boost::system::error_code& failure);
  void lose(std::string_view reason);
  void note_losses();
  void tell(const device::LifeCycle::Change& change) {
    if (change && events_.changed) events_.changed(*change);
  }

  boost::asio::io_context& io_;
  link::Uri uri_;
  link::Side side_;
  Events events_;
  device::LifeCycle life_;
  std::shared_ptr<io::Signal> wake_;  ///< for serve()
  std::optional<link::Pump<Link>> pump_;
  Link* link_ = nullptr;                ///< the open one
  std::uint64_t dropped_before_ = 0;    ///< by the link, when the last write ended
  bool taking_ = true;                  ///< the other side takes what is put
  std::optional<Stamp> waiting_since_;  ///< what the next write carries
  device::Reason why_lost_;
  Counters counters_;
  bool wanted_ = false, finished_ = false, closed_ = false;
};

extern template class Port<link::ByteLink>;
extern template class Port<link::FrameLink>;

}  // namespace drydock::proxy
