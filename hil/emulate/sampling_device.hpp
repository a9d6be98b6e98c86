#pragma once

#include <cstdint>
#include <memory>

#include "drivers/wire/canopen/cia404_pressure.hpp"
#include "hil/emulate/condition.hpp"
#include "hil/emulate/emulated_device.hpp"
#include "hil/emulate/make_emulated_device.hpp"
#include "hil/sensor/dropouts.hpp"
#include "hil/sensor/imu_errors.hpp"
#include "hil/sensor/imu_sampler.hpp"
#include "hil/sensor/mounting.hpp"
#include "hil/sensor/sky.hpp"

namespace drydock::emulate {

using motion::Trajectory;
using rig_config::DeviceConfig;

/// The parts from which an emulated device is made. The trajectory must outlive the device.
struct DeviceSetup {
  const DeviceConfig& config;
  const Trajectory& trajectory;
  std::uint64_t seed = 0;
  std::shared_ptr<sensor::Sky> sky = nullptr;  ///< kind gnss; used by this receiver only
  Stamp boot = trajectory.start();             ///< when it gets power
  std::shared_ptr<const Condition> condition = std::make_shared<Condition>();
  std::shared_ptr<Memory> memory = std::make_shared<Memory>();  ///< what it keeps without power

  sensor::ErrorModel primary_errors() const;
  sensor::ErrorModel secondary_errors() const;
  sensor::ImuErrors imu_errors() const;
  sensor::ImuSampler imu_sampler() const;
  wire::cia404_pressure::Scale pressure_scale() const;
};

/// A device that samples the truth at a constant rate and sends each sample `latency_s` later.
/// Sample k is at first + k / rate to the nanosecond; only a fault makes the rate drift, and only a
/// setting of the device changes it. A sample that drops out is taken and counted like any other,
/// but nothing of it reaches the wire.
class SamplingDevice : public EmulatedDevice {
 public:
  std::optional<Stamp> deadline() const override { return send_time(); }
  void tick(Stamp now, Wire& out) override;
  void receive(wire::Bytes, Stamp, Wire&) override {}
  void receive(const wire::CanFrame&, Stamp, Wire&) override {}
  std::optional<Stamp> sampled_at() const override { return under_way_; }

 protected:
  /// The first sample is at boot.
  explicit SamplingDevice(const DeviceSetup& setup);

  virtual void sample(Stamp at, Wire& out) = 0;
  /// During sample(): nothing of it reaches the wire, then or later.
  bool sample_is_lost() const { return lost_; }

  void take(Stamp at, Wire& out);  ///< calls sample(), with the dropouts of the configuration
  /// From the next sample on, which keeps its time. Error models keep the rate of the rig file.
  void go_on_at(double rate_hz);
  /// The same, at whole multiples of the new period in UTC after `now`.
  void go_on_at_whole_multiples(double rate_hz, Stamp now);
  void sample_at_whole_multiples();  ///< multiples of the period in UTC, as satellite receivers do
  const Trajectory& trajectory() const { return trajectory_; }
  const sensor::Mounting& mounting() const { return mounting_; }
  const Condition& condition() const { return *condition_; }
  /// The time that the device's own clock shows.
  Stamp device_time(Stamp at) const { return condition_->clock.shows(at); }
  double rate_hz() const { return rate_hz_; }
  std::chrono::nanoseconds latency() const { return latency_; }
  std::uint64_t samples() const { return samples_; }  ///< number taken before the current one

 private:
  Stamp sample_time() const;
  bool is_left_out();
  Stamp send_time() const { return sample_time() + latency_; }

  const Trajectory& trajectory_;
  sensor::Mounting mounting_;
  double rate_hz_;
  std::chrono::nanoseconds latency_;
  sensor::Dropouts dropouts_;
  std::shared_ptr<const Condition> condition_;
  double to_leave_out_ = 0;            ///< fraction of samples, for a slow device
  std::chrono::nanoseconds ahead_{0};  ///< how far a fast clock is ahead
  Stamp first_;
  std::uint64_t samples_ = 0;
  std::optional<Stamp> under_way_;
  bool lost_ = false;
};

}  // namespace drydock::emulate
