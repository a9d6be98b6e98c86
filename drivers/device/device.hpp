#pragma once

#include <boost/system/result.hpp>
#include <memory>
#include <string>
#include <variant>

#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/device/health.hpp"
#include "drivers/device/make_driver.hpp"
#include "drivers/device/news.hpp"
#include "drivers/device/rate_meter.hpp"

namespace drydock::device {

class Device;

/// Hears what the devices have to say. Called from the shell that runs them.
class Listener {
 public:
  virtual ~Listener() = default;
  virtual void on_measurement(const Measurement& measurement) = 0;
  /// A change of state that is news: `change.from` is the state that was told before.
  virtual void on_state(const Device& device, const Transition& change) = 0;
};

/// Takes what a driver sends to its sensor.
class Transmitter {
 public:
  virtual ~Transmitter() = default;
  virtual void send(wire::Bytes bytes) = 0;
  virtual void send(const wire::CanFrame& frame) = 0;
};

struct DeviceOptions {
  std::string name;
  std::string link;  ///< URI, for the shell
  DriverOptions driver;
  LifeCycleOptions life_cycle;
  double nominal_rate_hz = 0;
};

/// A sensor as the rig sees it: its driver, its life cycle, its health. Sans-I/O: a shell opens the
/// link when wants_open(), passes on what arrives, and calls tick() at deadline().
class Device final : private Output {
 public:
  /// Fails when no driver speaks the protocol for this kind of sensor.
  static boost::system::result<std::unique_ptr<Device>, DriverError> make(DeviceOptions options);

  /// Both must outlive the device; to be called once, before start().
  void connect(Listener& listener, Transmitter& transmitter);

  /// What its driver would send to the sensor goes nowhere.
  void listen_only() { listens_only_ = true; }

  void start(Stamp now);
  void opened(Stamp now, measurement::Provenance provenance);
  void set_baud(unsigned baud);  ///< before opened(), where the shell searches it
  void open_failed(Stamp now, std::string_view reason);
  void link_lost(Stamp now, std::string_view reason);
  void stop(Stamp now, std::string_view reason = "stopped");

  void receive(wire::Bytes bytes, Stamp at);  ///< `at`: arrival of the last byte
  void receive(const wire::CanFrame& frame, Stamp at);
  void tick(Stamp now);
  /// The host's clock was set by so much and shows `now`. The driver begins anew, as after opening:
  /// what it knows of the device's clock, and what it waits for, was told by the old one.
  void clock_stepped(std::chrono::nanoseconds step, Stamp now);
  std::optional<Stamp> deadline() const;

  State state() const { return life_cycle_.state(); }
  bool wants_open() const { return life_cycle_.wants_open(); }
  bool wants_close() const { return life_cycle_.wants_close(); }
  bool on_bus() const { return std::holds_alternative<std::unique_ptr<FrameDriver>>(driver_); }
  const DeviceOptions& options() const { return options_; }
  const std::string& name() const { return options_.name; }
  std::uint16_t index() const { return options_.driver.device; }

  std::uint64_t messages() const { return messages_; }
  Health health(Stamp now) const;
  void note_dropped(std::uint64_t total) { can_dropped_ = total; }  ///< FrameLink::dropped()

 private:
  using AnyDriver = std::variant<std::unique_ptr<ByteDriver>, std::unique_ptr<FrameDriver>>;

  Device(DeviceOptions options, AnyDriver driver);

  void publish(const Measurement& measurement) override;
  void send(wire::Bytes bytes) override;
  void send(const wire::CanFrame& frame) override;
  void report(std::string_view trouble) override { last_error_ = trouble; }

  Driver& driver() const;
  void tell(const LifeCycle::Change& change);

  DeviceOptions options_;
  AnyDriver driver_;
  LifeCycle life_cycle_;
  News news_;
  Listener* listener_ = nullptr;
  Transmitter* transmitter_ = nullptr;
  bool listens_only_ = false;
  Stamp now_{};  ///< of the call under way
  std::array<RateMeter, 4> rates_;
  std::uint64_t messages_ = 0;
  std::optional<Stamp> last_message_at_;
  Reason last_error_;
  std::uint64_t can_dropped_ = 0;
  std::uint64_t error_frames_ = 0;
};

}  // namespace drydock::device
