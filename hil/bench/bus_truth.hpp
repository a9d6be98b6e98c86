#pragma once

#include <optional>

#include "drivers/bus/clock_writer.hpp"
#include "drivers/bus/publisher.hpp"
#include "drivers/host/follower.hpp"
#include "estimators/frame/geodetic.hpp"
#include "hil/motion/truth.hpp"

namespace drydock::bench {

/// Puts the truth on the bus, for programs that are to be compared with it: sensor_msgs/Imu,
/// nav_msgs/Odometry and sensor_msgs/NavSatFix on `rt/estimate/truth...`, and the time on
/// `rt/clock`. One message of each for each sample of an IMU, at most 100 a second.
class BusTruth final : public host::Follower {
 public:
  /// The truth must outlive it.
  BusTruth(const bus::Participant& participant, const motion::Trajectory& truth);

  void on_measurement(const measurement::Measurement& measurement) override;

 private:
  const motion::Trajectory& truth_;
  bus::Publisher to_;
  bus::ClockWriter clock_;
  measurement::Stamp last_{};
  std::optional<frame::Position> origin_;
};

}  // namespace drydock::bench
