#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "drivers/device/device.hpp"

namespace drydock::survey {

using device::Kind;
using measurement::Stamp;

/// A driver that got measurements out of a wire.
struct SensorHeard {
  Kind kind = Kind::dvl;
  std::string_view protocol;
  std::uint64_t measurements = 0;
  /// Of its fastest kind of measurement; empty while there are too few, or without times.
  std::optional<double> rate_hz;
};

/// A sensor's driver tried on what a wire says: does it give measurements, and could they be true?
/// What the driver would send goes nowhere.
class DriverTrial final : private device::Listener, private device::Transmitter {
 public:
  /// `address` 0: any. The protocol must be one of protocols_of(kind).
  DriverTrial(Kind kind, std::string_view protocol, std::uint8_t address = 0);

  void receive(wire::Bytes bytes, Stamp at);
  void receive(const wire::CanFrame& frame, Stamp at);

  Kind kind() const { return device_->options().driver.kind; }
  std::string_view protocol() const { return device_->options().driver.protocol; }
  std::uint64_t measurements() const { return measurements_; }
  SensorHeard heard() const;
  wire::StreamCounters counters() const { return device_->health(now_).stream; }

  /// Share of the measurements that a vehicle's sensor could give: specific forces within 0.3 to
  /// 3 g, rates below 2000 deg/s, pressures from 0.2 bar to 1200 bar. 1 where nothing can be said.
  double plausible_share() const;
  /// |mean specific force / g - 1|: tells scale factors apart. Empty without an IMU's samples.
  std::optional<double> gravity_error() const;

 private:
  void on_measurement(const measurement::Measurement& measurement) override;
  void on_state(const device::Device&, const device::Transition&) override {}
  void send(wire::Bytes) override {}
  void send(const wire::CanFrame&) override {}
  void begin(Stamp at);

  std::unique_ptr<device::Device> device_;
  bool begun_ = false;
  Stamp now_{};
  std::uint64_t measurements_ = 0, judged_ = 0, plausible_ = 0, forces_ = 0;
  double force_sum_mps2_ = 0;
};

/// The drivers that understand the protocol, one for each kind of sensor that speaks it.
std::vector<std::unique_ptr<DriverTrial>> trials_of(std::string_view protocol,
                                                    std::uint8_t address = 0);

/// Which of two understood more of the same wire; `a` may be null. Null where neither has
/// measurements that could be true.
const DriverTrial* better_of(const DriverTrial* a, const DriverTrial* b);

}  // namespace drydock::survey
