#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "drivers/bus/publisher.hpp"
#include "drivers/device/device.hpp"
#include "drivers/shell/real_time.hpp"
#include "rig_config/rig.hpp"

namespace drydock::host {

/// Runs the drivers of a rig on their links in real time. It publishes measurements and health on
/// the bus.
class DriverHost final : private device::Listener {
 public:
  /// `bus` may be null: then nothing is published. The publisher and the listener for raw bytes and
  /// frames must outlive the host.
  DriverHost(boost::asio::io_context& io, std::vector<std::unique_ptr<device::Device>> devices,
             bus::Publisher* bus, shell::RawListener* raw = nullptr);

  /// Called for every measurement and state change, in addition to the bus.
  std::function<void(const measurement::Measurement&)> on_measurement_hook;
  std::function<void(const device::Device&, const device::Transition&)> on_state_hook;
  std::function<void(std::span<const bus::DeviceStatus>, measurement::Stamp)> on_health_hook;

  void start();
  void stop();
  const shell::RealTime& shell() const { return shell_; }
  bool all_streaming() const;

 private:
  void on_measurement(const measurement::Measurement& measurement) override;
  void on_state(const device::Device& device, const device::Transition& change) override;
  void publish_health();
  void schedule_health();

  bus::Publisher* bus_;
  shell::RealTime shell_;
  boost::asio::steady_timer health_timer_;
  bool stopped_ = false;  ///< an expired timer can no longer be cancelled
};

}  // namespace drydock::host
