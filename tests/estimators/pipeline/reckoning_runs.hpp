#pragma once

#include <Eigen/Core>
#include <numbers>
#include <vector>

#include "estimators/pipeline/reckoning/dead_reckoning_estimator.hpp"
#include "tests/estimators/pipeline/support.hpp"

/// Samples of the devices that dead reckoning has, and a run of it.
namespace drydock::pipeline::reckoning_runs {

using Eigen::Vector3d;

inline constexpr double degree = std::numbers::pi / 180;
inline constexpr std::uint16_t dvl_device = 1, log_device = 2, compass_device = 3, depth_device = 4,
                               gnss_device = 5;
inline const frame::Position start{41.55 * degree, -70.7 * degree, 0};

inline ReckoningDevice at_origin(std::uint16_t device) {
  ReckoningDevice there;
  there.index = device;
  return there;
}
inline ReckoningDevice at(std::uint16_t device, const Vector3d& lever) {
  ReckoningDevice there = at_origin(device);
  there.lever = lever;
  return there;
}

inline ReckoningOptions by_dvl() {
  ReckoningOptions options;
  options.dvl = at_origin(dvl_device);
  options.start = start;
  return options;
}

inline measurement::Origin origin(std::int64_t ms, std::uint16_t device) {
  measurement::Origin origin;
  origin.valid_at = origin.received_at = test::at_ms(ms);
  origin.device = device;
  return origin;
}

inline measurement::BottomVelocity track(std::int64_t ms, const Vector3d& body,
                                         double heading_rad) {
  measurement::BottomVelocity track;
  track.origin = origin(ms, dvl_device);
  track.velocity = body;
  track.heading_rad = heading_rad;
  track.pitch_rad = track.roll_rad = 0;
  return track;
}

inline measurement::AttitudeSample compass(std::int64_t ms, double true_heading_rad) {
  measurement::AttitudeSample sample;
  sample.origin = origin(ms, compass_device);
  sample.true_heading_rad = true_heading_rad;
  return sample;
}

inline measurement::WaterSpeed log_speed(std::int64_t ms, double mps) {
  measurement::WaterSpeed speed;
  speed.origin = origin(ms, log_device);
  speed.longitudinal_mps = mps;
  return speed;
}

/// `sigma_m`: of an axis.
inline measurement::GnssFix fix(std::int64_t ms, const Vector3d& offset, double sigma_m = 2) {
  const auto place = frame::at_ned_offset(start, offset);
  measurement::GnssFix fix;
  fix.origin = origin(ms, gnss_device);
  fix.position = measurement::Geodetic{place.latitude_rad, place.longitude_rad};
  fix.horizontal_accuracy_m = std::numbers::sqrt2 * sigma_m;
  return fix;
}

/// One estimator, and all that it told.
struct Reckoning final : EstimateListener {
  explicit Reckoning(const ReckoningOptions& options)
      : estimator(Seat{.index = 0, .imu = 0}, options, PipelineOptions{}) {}

  template <class Sample>
  Outcome take(const Sample& sample) {
    return estimator.take(sample, *this);
  }
  void on_attitude(const AttitudeEstimate&) override {}
  void on_navigation(const NavigationEstimate& estimate) override { all.push_back(estimate); }
  void on_innovation(const InnovationReport& report) override { innovations.push_back(report); }
  Vector3d offset() const { return frame::ned_offset(start, all.back().position); }

  DeadReckoningEstimator estimator;
  std::vector<NavigationEstimate> all;
  std::vector<InnovationReport> innovations;
};

}  // namespace drydock::pipeline::reckoning_runs
