#pragma once

#include <boost/asio/io_context.hpp>
#include <memory>
#include <vector>

#include "drivers/device/device.hpp"
#include "drivers/shell/raw_listener.hpp"

namespace drydock::shell {

class Line;

/// Runs devices on real links with the host's clock. Each serial line or bus has two coroutines:
/// one opens it, reads until it is lost, backs off and opens it again; the other serves the
/// deadlines of the devices. Everything runs on the thread of the io_context. Devices that name the
/// same link share one port, one connection or one bus.
class RealTime {
 public:
  /// The listeners must outlive the shell. Throws std::invalid_argument for a bad link URI;
  /// make_devices() refuses such a URI earlier.
  RealTime(boost::asio::io_context& io, std::vector<std::unique_ptr<device::Device>> devices,
           device::Listener& listener, RawListener* raw = nullptr);
  /// The io_context must have stopped, or must have finished all work since stop().
  ~RealTime();

  void start();
  /// Closes every link. The coroutines end, and io_context::run() returns if nothing else waits.
  void stop();

  /// A frame for a CAN link of the devices, from somebody who is no driver. It is lost while the
  /// link is not open.
  void send(std::string_view link, const wire::CanFrame& frame);

  std::size_t size() const { return devices_.size(); }
  const device::Device& device(std::size_t i) const { return *devices_[i]; }
  device::Health health(std::size_t i) const;  ///< at the time of the call

 private:
  std::vector<std::unique_ptr<device::Device>> devices_;
  std::vector<std::unique_ptr<Line>> lines_;
};

}  // namespace drydock::shell
