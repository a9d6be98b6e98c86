#pragma once

#include <boost/asio/io_context.hpp>
#include <optional>
#include <string>
#include <vector>

#include "drivers/device/device.hpp"
#include "drivers/io/signal.hpp"
#include "drivers/link/clock.hpp"
#include "drivers/link/link.hpp"
#include "drivers/shell/raw_listener.hpp"

namespace drydock::shell {

/// Serves one link for its devices in real time: opens it when a device wants it, reads until it is
/// lost, and ticks the devices at their deadlines. If several devices share it, it is opened again
/// when all of them are silent. Subclasses handle the content of the link.
class Line : protected device::Transmitter {
 public:
  Line(boost::asio::io_context& io, link::Uri uri, RawListener* raw);
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  void add(device::Device& device, device::Listener& listener);
  void start();
  void stop();
  const link::Uri& uri() const { return uri_; }
  /// Sends a frame of somebody who is no driver. A line for bytes, or one that is not open, loses
  /// it.
  virtual void transmit(const wire::CanFrame&) {}

 protected:
  using Provenance = measurement::Provenance;
  using Run = boost::asio::awaitable<void>;

  virtual boost::system::result<Provenance, link::OpenError> open_link() = 0;
  virtual Run serve_link() = 0;     ///< reads and writes; calls lost() with the reason of the end
  virtual void close_link() = 0;    ///< pending reads and writes end
  virtual void destroy_link() = 0;  ///< no read or write is pending any more
  virtual void observe_link() {}    ///< at the deadlines, while the link is open

  bool is_open() const { return open_; }
  void lost(const boost::system::error_code& reason);
  /// Sets the timer again: a driver may want its tick() earlier after it received data.
  void rearm();
  /// Tells the devices about a change of the host's clock before they receive a stamp of the new
  /// time.
  void follow_clock();
  void tap(Direction direction, wire::Bytes bytes, Stamp at) const;
  void tap(Direction direction, const wire::CanFrame& frame, Stamp at) const;
  const std::vector<device::Device*>& devices() const { return devices_; }
  boost::asio::any_io_executor executor() const { return io_.get_executor(); }

 private:
  Run run();
  Run serve(Provenance provenance);
  Run keep_time();
  bool open_wanted() const;
  std::optional<Stamp> earliest_deadline() const;
  std::optional<Stamp> all_give_up_at() const;
  void give_up_together(Stamp now);

  boost::asio::io_context& io_;
  link::Uri uri_;
  RawListener* raw_;
  std::vector<device::Device*> devices_;
  std::shared_ptr<io::Signal> clock_;  ///< wakes at the earliest deadline
  std::optional<Stamp> clock_set_for_;
  link::ClockWatch host_clock_;
  std::shared_ptr<io::Signal> to_open_;  ///< notified when a device wants the link
  bool open_ = false;
  bool stopped_ = false;
  std::string lost_reason_;
  bool recording_ended_ = false;
};

}  // namespace drydock::shell
