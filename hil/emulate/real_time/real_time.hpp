#pragma once

#include <boost/system/result.hpp>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hil/emulate/make_emulated_device.hpp"

namespace boost::asio {
class io_context;
}

namespace drydock::emulate {

class Runner;
class LineRunner;
class BusRunner;

/// Runs emulated devices against the host's clock on the device side of their links: one line or
/// bus per link with all devices that name it. It wakes only when a
/// chunk or a frame is due. Bench time equals the trajectory's time: start the trajectory at
/// link::steady_now(), which runs evenly even if the host's clock is set. When a device's port
/// goes, the device closes its end of the link; when the port comes back, a new link has the same
/// name. Everything runs on the thread of the io_context.
class RealTimeEmulator {
 public:
  struct Counters {
    std::uint64_t messages = 0;  ///< messages or frames written
    std::uint64_t late = 0;      ///< chunks or frames written more than 5 ms late
    std::uint64_t lost = 0;      ///< messages or frames dropped because the line was overloaded
    std::uint64_t write_errors = 0;
    std::uint64_t not_taken = 0;  ///< bytes that a reader who was there did not take in time
  };

  /// Called when the last byte of a message, or a frame, was handed to the host. `passage` has the
  /// time at which this was due.
  using OnWritten =
      std::function<void(std::string_view device, const Passage& passage, Stamp written)>;

  /// Called with what a host has told a device.
  using OnTold = std::function<void(std::string_view device, std::string_view what)>;

  /// Both must outlive the emulator.
  RealTimeEmulator(boost::asio::io_context& io, DeviceMaker& maker);
  ~RealTimeEmulator();

  void set_on_written(OnWritten hook);  ///< call it before start()
  void set_on_told(OnTold hook);        ///< call it before start()

  /// Opens the links and starts the devices. An error names the device and the problem.
  boost::system::result<void, EmulateError> start(
      const std::vector<rig_config::DeviceConfig>& devices);

  /// Call it when a device's deadline may have become earlier.
  void wake();

  /// Closes the links. The coroutines end, and io_context::run() returns if nothing else waits.
  void stop();

  Counters counters() const;  ///< total of all lines
  /// In words, `pty:gnss?baud=9600: 630`: the links that lost messages, and how many.
  std::string overloaded_links() const;

 private:
  boost::system::result<void, EmulateError> add(const rig_config::DeviceConfig& config);

  boost::asio::io_context& io_;
  DeviceMaker& maker_;
  OnWritten on_written_;
  OnTold on_told_;
  std::vector<std::shared_ptr<Runner>> runners_;
  std::map<std::string, std::shared_ptr<LineRunner>> lines_;  ///< by link; runners_ has them too
  std::map<std::string, std::shared_ptr<BusRunner>> buses_;   ///< likewise
};

}  // namespace drydock::emulate
