#pragma once

#include <boost/asio/io_context.hpp>
#include <memory>
#include <string_view>
#include <vector>

#include "drivers/device/device.hpp"

namespace drydock::shell {

using measurement::Stamp;

enum class Direction : std::uint8_t { received, sent };

/// Sees every byte and frame below the drivers, both directions, before anything is understood.
class RawListener {
 public:
  virtual ~RawListener() = default;
  virtual void on_bytes(std::string_view link, Direction direction, wire::Bytes bytes,
                        Stamp at) = 0;
  virtual void on_frame(std::string_view link, Direction direction, const wire::CanFrame& frame,
                        Stamp at) = 0;
};

/// Runs devices over real links and the host's clock: one coroutine per serial line or bus (open,
/// read until lost, back off, open again) and one timer per device. All on the thread that runs the
/// io_context. Devices with the same CAN link share one bus.
class RealTime {
 public:
  /// The listeners must outlive the shell. The shell must outlive the run of the io_context.
  RealTime(boost::asio::io_context& io, std::vector<std::unique_ptr<device::Device>> devices,
           device::Listener& listener, RawListener* raw = nullptr);
  ~RealTime();

  void start();
  /// Closes every link; the coroutines end, and io_context::run() returns when nothing else waits.
  void stop();

  std::size_t size() const { return devices_.size(); }
  const device::Device& device(std::size_t i) const { return *devices_[i]; }
  device::Health health(std::size_t i) const;  ///< now

 private:
  class Line;  ///< what serves one link
  class ByteLine;
  class BusLine;

  boost::asio::io_context& io_;
  std::vector<std::unique_ptr<device::Device>> devices_;
  std::vector<std::unique_ptr<Line>> lines_;
};

}  // namespace drydock::shell
