#pragma once

#include <boost/asio/io_context.hpp>
#include <map>

#include "drivers/host/follower.hpp"
#include "hil/pilot/pilot.hpp"
#include "hil/pilot/real_time/order_bus.hpp"

namespace drydock::pilot {

/// The pilot in real time: it follows the drivers' measurements and has its own place on each bus.
class RealTimePilot final : public host::Follower {
 public:
  /// Throws as Pilot. Rig and io_context must outlive it.
  RealTimePilot(boost::asio::io_context& io, const rig_config::Rig& rig, Stamp start,
                OrderPorts::Say say);

  void start();
  void stop();
  const Pilot& pilot() const { return pilot_; }

  void on_measurement(const measurement::Measurement& m) override { pilot_.receive(m); }

 private:
  boost::asio::awaitable<void> keep_time();
  void send(const std::string& link, const wire::CanFrame& frame);

  boost::asio::io_context& io_;
  Pilot pilot_;
  std::map<std::string, std::shared_ptr<OrderBus>> buses_;
  std::shared_ptr<io::Signal> clock_;
  bool stopped_ = false;
};

}  // namespace drydock::pilot
