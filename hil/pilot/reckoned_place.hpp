#pragma once

#include "estimators/frame/geodetic.hpp"
#include "hil/motion/vehicle/vehicle_motion.hpp"
#include "hil/pilot/measured_state.hpp"

namespace drydock::pilot {

/// Where the vehicle is as its sensors say: from where the mission begins it adds up the velocity
/// over ground of the first DVL, without one that is fresh the velocity through the water. A
/// position of the first GNSS receiver replaces the sum.
class ReckonedPlace {
 public:
  /// The mission begins at `start`.
  ReckonedPlace(const rig_config::Rig& rig, Stamp start);

  void receive(const measurement::Measurement& m);

  /// Goes on to `now`, at most one second at once, and sets latitude and longitude of the state.
  void place(motion::VehicleState& state, Stamp now);

 private:
  struct Source {
    std::optional<std::uint16_t> device;  ///< empty: the rig has none
    Eigen::Vector3d lever_arm_m = Eigen::Vector3d::Zero();
  };

  static Source first_of(const rig_config::Rig& rig, rig_config::DeviceKind kind);
  Eigen::Vector3d velocity_ned(const motion::VehicleState& state, Stamp now) const;

  Source dvl_, gnss_;
  frame::Position at_;
  Stamp reckoned_at_;
  std::optional<Eigen::Vector3d> over_ground_;  ///< body, m/s; of the DVL
  Stamp over_ground_at_{};
  std::optional<measurement::Geodetic> fix_;  ///< not taken up yet
};

}  // namespace drydock::pilot
