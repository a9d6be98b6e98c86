#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <memory>
#include <vector>

#include "drivers/device/device.hpp"
#include "drivers/host/follower.hpp"
#include "drivers/host/wake_watch.hpp"
#include "drivers/shell/real_time.hpp"

namespace drydock::host {

/// Runs the drivers of a rig on their links in real time. It tells a follower their raw data,
/// measurements, states, and each second their health.
class DriverHost final : private device::Listener, private shell::RawListener {
 public:
  /// The follower must outlive the host.
  DriverHost(boost::asio::io_context& io, std::vector<std::unique_ptr<device::Device>> devices,
             Follower& follower);

  void start();
  void stop();  ///< closes the links; the follower does not hear that the devices close
  const shell::RealTime& shell() const { return shell_; }
  /// See shell::RealTime::send().
  void send(std::string_view link, const wire::CanFrame& frame) { shell_.send(link, frame); }
  std::vector<const device::Device*> devices() const;
  bool all_streaming() const;

 private:
  using Stamp = measurement::Stamp;

  void on_bytes(std::string_view link, shell::Direction way, wire::Bytes bytes, Stamp at) override {
    wakes_.look();
    follower_.on_bytes(link, way, bytes, at);
  }
  void on_frame(std::string_view link, shell::Direction way, const wire::CanFrame& frame,
                Stamp at) override {
    wakes_.look();
    follower_.on_frame(link, way, frame, at);
  }
  void on_measurement(const measurement::Measurement& measurement) override {
    follower_.on_measurement(measurement);
  }
  void on_state(const device::Device& device, const device::Transition& change) override {
    if (!stopped_) follower_.on_state(device, change);
  }
  void tell_health();
  void note_stall();
  void schedule_health();

  Follower& follower_;
  WakeWatch wakes_;
  shell::RealTime shell_;
  boost::asio::steady_timer health_timer_;
  bool stopped_ = false;  ///< an expired timer can no longer be cancelled
};

}  // namespace drydock::host
