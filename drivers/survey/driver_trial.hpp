#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/device/device.hpp"
#include "drivers/wire/described/description.hpp"

namespace drydock::survey {

using device::Kind;
using measurement::Stamp;

/// A driver that decoded measurements from a wire.
struct SensorHeard {
  Kind kind = Kind::dvl;
  std::string_view protocol;
  std::uint64_t measurements = 0;
  /// Rate of its fastest kind of measurement. Empty if there are too few, or without times.
  std::optional<double> rate_hz;
  wire::described::DescriptionPtr description{};  ///< of a protocol that a file describes
  std::string evidence{};  ///< on a bus: what speaks for the description, and against it
};

/// Tries a sensor's driver on the data of a wire: does it give measurements, and are they
/// plausible? Data that the driver sends are discarded.
class DriverTrial final : private device::Listener, private device::Transmitter {
 public:
  /// `address` 0: any. The protocol must be one of protocols_of(kind).
  DriverTrial(Kind kind, std::string_view protocol, std::uint8_t address = 0);
  explicit DriverTrial(const wire::described::DescriptionPtr& description);

  void receive(wire::Bytes bytes, Stamp at);
  void receive(const wire::CanFrame& frame, Stamp at);
  void finish(Stamp at);  ///< no more comes: what waits in the driver comes out

  Kind kind() const { return device_->options().driver.kind; }
  std::string_view protocol() const { return device_->options().driver.protocol; }
  std::uint64_t measurements() const { return measurements_; }
  SensorHeard heard() const;
  wire::StreamCounters counters() const { return device_->health(now_).stream; }

  /// Share of plausible measurements for a vehicle: specific forces within 0.3 to 3 g, rates below
  /// 2000 deg/s, pressures from 0.2 bar to 1200 bar. 1 if nothing can be judged.
  double plausible_share() const;
  /// |mean specific force / g - 1|: distinguishes scale factors. Empty without samples of an IMU.
  std::optional<double> gravity_error() const;

 private:
  explicit DriverTrial(device::DeviceOptions options);

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

/// The one driver of a description.
std::vector<std::unique_ptr<DriverTrial>> trials_of(
    const wire::described::DescriptionPtr& description);

/// The one of two that understood more of the same wire; `a` may be null. Null if neither has
/// plausible measurements.
const DriverTrial* better_of(const DriverTrial* a, const DriverTrial* b);

}  // namespace drydock::survey
