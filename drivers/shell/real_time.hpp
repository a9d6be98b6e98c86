#pragma once

#include <boost/asio/io_context.hpp>
#include <memory>
#include <vector>

#include "drivers/device/device.hpp"
#include "drivers/shell/raw_listener.hpp"

namespace drydock::shell {

class Line;

/// Runs devices over real links and the host's clock: for each serial line or bus one coroutine
/// that opens it, reads until it is lost, backs off and opens again, and one that keeps the
/// devices' deadlines. All on the thread that runs the io_context. Devices that name the same CAN
/// link share one bus.
class RealTime {
 public:
  /// The listeners must outlive the shell. Throws std::invalid_argument for a bad link URI, which
  /// make_devices() would have refused.
  RealTime(boost::asio::io_context& io, std::vector<std::unique_ptr<device::Device>> devices,
           device::Listener& listener, RawListener* raw = nullptr);
  /// The io_context must not run any more, or have ended everything since stop().
  ~RealTime();

  void start();
  /// Closes every link; the coroutines end, and io_context::run() returns when nothing else waits.
  void stop();

  std::size_t size() const { return devices_.size(); }
  const device::Device& device(std::size_t i) const { return *devices_[i]; }
  device::Health health(std::size_t i) const;  ///< now

 private:
  std::vector<std::unique_ptr<device::Device>> devices_;
  std::vector<std::unique_ptr<Line>> lines_;
};

}  // namespace drydock::shell
