#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "drivers/measurement/measurement.hpp"
#include "hil/motion/vehicle/vehicle_motion.hpp"
#include "rig_config/rig.hpp"

namespace drydock::pilot {

using measurement::Stamp;

/// The state of the vehicle as its sensors say: attitude, depth, speed through the water, rates of
/// turn. Of each kind the first device of the rig counts. Lever arms are taken off.
class MeasuredState {
 public:
  /// A value older than this steers no more.
  static constexpr std::chrono::seconds oldest{1};

  /// Throws std::runtime_error (one line) if the rig lacks a kind of sensor.
  explicit MeasuredState(const rig_config::Rig& rig);

  void receive(const measurement::Measurement& m);

  /// Latitude and longitude are 0. Empty: missing() says what is not there.
  std::optional<motion::VehicleState> at(Stamp now) const;
  std::string_view missing(Stamp now) const;

 private:
  struct Value {
    double value = 0;
    Stamp at{};
  };
  struct Source {
    std::uint16_t device = 0;
    Eigen::Vector3d lever_arm_m = Eigen::Vector3d::Zero();
  };

  void take(const measurement::AttitudeSample& sample);
  void take(const measurement::DepthSample& sample);
  void take(const measurement::WaterSpeed& sample);
  void take(const measurement::ImuSample& sample);
  template <class Other>
  void take(const Other&) {}

  bool fresh(const std::optional<Value>& value, Stamp now) const {
    return value && now - value->at <= oldest;
  }

  Source attitude_, depth_, log_, imu_;
  std::optional<Value> roll_, pitch_, heading_, depth_m_, speed_mps_, rates_known_;
  Eigen::Vector3d rates_ = Eigen::Vector3d::Zero();
};

}  // namespace drydock::pilot
