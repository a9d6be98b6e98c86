#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "drivers/host/told_status.hpp"
#include "rig_config/rig.hpp"

namespace drydock::bench {

/// Puts on `rt/diagnostics` what hosts have told the emulated devices of a process without drivers:
/// at once, and again each second. It joins the bus when a device is told something for the first
/// time.
class ToldOnBus {
 public:
  using Say = std::function<void(const std::string& line)>;

  /// All of them must outlive it. A rig that publishes nothing stays off the bus.
  ToldOnBus(boost::asio::io_context& io, const rig_config::Rig& rig, Say say);
  ~ToldOnBus();

  /// Replaces what the device was told before.
  void tell(const host::Told& told);
  void stop();

 private:
  bool joins();
  void publish();
  void keep_publishing();

  struct Writer;
  const rig_config::Rig& rig_;
  Say say_;
  boost::asio::steady_timer timer_;
  std::unique_ptr<Writer> writer_;  ///< null: not on the bus
  std::vector<bus::DeviceStatus> told_;
  bool off_;  ///< it never joins, or it has stopped
};

}  // namespace drydock::bench
