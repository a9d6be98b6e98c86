#pragma once

#include <boost/system/result.hpp>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "hil/emulate/make_emulated_device.hpp"

namespace boost::asio {
class io_context;
}

namespace drydock::emulate {

class Runner;

/// Runs emulated devices against the host's clock, each on the device side of its link: one line
/// per byte device, one bus per CAN link with all devices that name it. It wakes only when a chunk
/// or a frame is due. Bench time and the trajectory's time are the same: start the trajectory at
/// link::steady_now(), which goes on evenly when the host's clock is set. A device whose port goes
/// closes its end of the link, and a new one stands under the same name when it comes back.
/// Everything runs on the thread of the io_context.
class RealTimeEmulator {
 public:
  struct Counters {
    std::uint64_t messages = 0;  ///< messages or frames written
    std::uint64_t late = 0;      ///< chunks or frames written over 5 ms after their time
    std::uint64_t lost = 0;      ///< messages or frames dropped because the line was overloaded
    std::uint64_t write_errors = 0;
  };

  /// Hears when the last byte of a message, or a frame, of a device was handed to the host, and
  /// when it should have been.
  using OnWritten =
      std::function<void(std::string_view device, const Passage& passage, Stamp written)>;

  /// Both must outlive the emulator.
  RealTimeEmulator(boost::asio::io_context& io, DeviceMaker& maker);
  ~RealTimeEmulator();

  void set_on_written(OnWritten hook);  ///< to be called before start()

  /// Opens the links and starts the devices. The error names the device and what is wrong with it.
  boost::system::result<void, EmulateError> start(
      const std::vector<rig_config::DeviceConfig>& devices);

  /// A device's deadline may have come nearer from without.
  void wake();

  /// Closes the links; the coroutines end and io_context::run() returns when nothing else waits.
  void stop();

  Counters counters() const;  ///< of all lines together

 private:
  boost::system::result<void, EmulateError> add(const rig_config::DeviceConfig& config);

  boost::asio::io_context& io_;
  DeviceMaker& maker_;
  OnWritten on_written_;
  std::vector<std::shared_ptr<Runner>> runners_;
};

}  // namespace drydock::emulate
