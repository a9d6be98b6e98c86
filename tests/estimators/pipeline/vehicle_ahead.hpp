#pragma once

#include <cmath>
#include <random>

#include "estimators/frame/earth.hpp"
#include "tests/estimators/pipeline/support.hpp"

namespace drydock::pipeline::test {

constexpr double one_degree = 0.0174533;

/// A level vehicle at 2 m/s straight ahead to the north. IMU 100 Hz with noise of 1e-5 rad/s and
/// .005 m/s2, as the filters assume; log 2 Hz with .05 m/s.
class Ahead {
 public:
  explicit Ahead(EstimatorKind kind) {
    PipelineOptions options = moving(std::chrono::milliseconds{200});
    options.estimators[0].kind = std::move(kind);
    pipeline.emplace(*make_pipeline(options, estimates));
  }

  void run(double seconds) {
    for (long i = std::lround(100 * seconds); i > 0; --i) {
      if (tick % 50 == 0) {
        const double noise = 0.05 * normal_(random_);
        pipeline->receive(water_speed(10 * tick, 2 + noise + log_error));
      }
      auto imu = pipeline::test::imu(10 * tick++);
      imu.angular_rate = frame::earth_rate_ned(0.6) + 1e-5 * noise() + rate_error;
      imu.specific_force = Eigen::Vector3d{0, 0, -9.8} + 0.005 * noise() + force_error;
      if (nan) imu.angular_rate.x() = std::nan("");
      if (spikes && tick % 7 == 0) imu.angular_rate.y() += 100 * one_degree;
      if (!silent) pipeline->receive(imu);
    }
  }
  bool valid() const { return pipeline->valid(0, at_ms(10 * tick)); }
  EstimatorStatus status() const { return pipeline->status(0); }
  double tilt() const {
    return std::hypot(estimates.all.back().roll_rad, estimates.all.back().pitch_rad);
  }

  Estimates estimates;
  std::optional<Pipeline> pipeline;
  std::int64_t tick = 0;
  Eigen::Vector3d rate_error = Eigen::Vector3d::Zero(), force_error = Eigen::Vector3d::Zero();
  double log_error = 0;
  bool spikes = false, silent = false, nan = false;

 private:
  Eigen::Vector3d noise() { return {normal_(random_), normal_(random_), normal_(random_)}; }

  std::mt19937_64 random_{8};
  std::normal_distribution<double> normal_;
};

inline EstimatorKind leveling_kind(leveling::FilterKind kind = leveling::FilterKind::augmented) {
  LevelingOptions options;
  options.log = log_device;
  options.kind = kind;
  options.filter = leveling::options_for(kind);
  options.filter.latitude_rad = 0.6;
  return options;
}

inline EstimatorKind mixing_kind() {
  MixingOptions options;
  options.log = log_device;
  options.filter.latitude_rad = 0.6;
  return options;
}

}  // namespace drydock::pipeline::test
