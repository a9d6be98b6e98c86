#pragma once

#include <boost/asio/io_context.hpp>
#include <map>

#include "drivers/host/follower.hpp"
#include "drivers/io/signal.hpp"
#include "hil/pilot/pilot.hpp"

namespace drydock::pilot {

/// The pilot in real time. It follows the drivers' measurements and the frames on their buses, and
/// sends on the same links, which only one program can open. All on the thread of the io_context.
class RealTimePilot final : public host::Follower {
 public:
  /// Throws as Pilot. `send` puts a frame on a bus of the drivers. Rig and io_context must outlive
  /// it.
  RealTimePilot(boost::asio::io_context& io, const rig_config::Rig& rig, Stamp start,
                const OrderPorts::Send& send, OrderPorts::Say say);

  void start();
  void stop();

  void on_measurement(const measurement::Measurement& m) override { pilot_.receive(m); }
  void on_frame(std::string_view link, shell::Direction way, const wire::CanFrame& frame,
                Stamp at) override;

 private:
  boost::asio::awaitable<void> keep_time();

  boost::asio::io_context& io_;
  Pilot pilot_;
  std::map<std::string, std::optional<Stamp>, std::less<>> heard_at_;  ///< by bus
  std::shared_ptr<io::Signal> clock_;
  bool stopped_ = false;
};

}  // namespace drydock::pilot
