#pragma once

#include <map>
#include <vector>

#include "drivers/host/follower.hpp"
#include "hil/track/attitudes.hpp"
#include "hil/track/gathered.hpp"

namespace drydock::track {

/// Turns the measurements of a replay into readings. What cannot be used is counted by its reason.
class Gatherer final : public host::Follower {
 public:
  /// `inertial`: keep the samples of this IMU. The rig must outlive the gatherer.
  Gatherer(const rig_config::Rig& rig, std::optional<std::uint16_t> inertial);
  /// The times are those of a device's own clock: where a receiver tells UTC, that counts.
  void take_utc_of_receiver() { utc_of_receiver_ = true; }

  void on_measurement(const measurement::Measurement& measurement) override;
  void on_truth(const host::Estimate& truth) override;

  /// Everything in the order of its times, which count from the first measurement.
  Gathered take();

 private:
  using Quantity = smoothing::Quantity;

  void hear(const measurement::BottomVelocity& track);
  void hear(const measurement::WaterSpeed& speed);
  void hear(const measurement::DepthSample& sample);
  void hear(const measurement::AttitudeSample& sample);
  void hear(const measurement::GnssFix& fix);
  void hear(const measurement::ImuSample& sample);
  void hear(const measurement::GnssSatellites&) {}
  void hear(const measurement::ActuatorState&) {}

  /// Adds a reading; `sigma` empty: the sensor does not state it, and `usual` is a first guess.
  void add(Quantity quantity, const measurement::Origin& origin, const Eigen::Vector3d& value,
           const std::optional<Eigen::Vector3d>& sigma, const Eigen::Vector3d& usual);
  void add(Quantity quantity, const measurement::Origin& origin, const Eigen::Vector3d& value,
           const std::optional<Eigen::Vector3d>& sigma, double usual);
  void take_attitudes();
  void take_own_depths();
  double time_of(Stamp at);
  void pass_over(const std::string& reason) { ++gathered_.passed_over[reason]; }

  const rig_config::Rig& rig_;
  std::optional<std::uint16_t> inertial_;
  bool utc_of_receiver_ = false;
  bool started_ = false;
  std::optional<std::chrono::nanoseconds> utc_ahead_;  ///< of the times of the measurements
  Gathered gathered_;
  Attitudes attitudes_;
  struct HeadDepth {
    measurement::Origin origin;
    double m;
  };
  std::map<std::uint16_t, std::vector<HeadDepth>> head_depths_;  ///< of DVLs, by device
};

}  // namespace drydock::track
