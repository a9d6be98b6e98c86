#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "estimators/consistency/devices.hpp"
#include "estimators/consistency/inertial_unit.hpp"
#include "estimators/consistency/tracks.hpp"

namespace drydock::consistency {

/// All that the devices of a rig said.
struct Tracks {
  std::vector<DvlTracks> dvls;
  std::vector<LogTracks> logs;
  std::vector<GnssTracks> receivers;
  std::vector<InertialUnit> units;
  std::vector<DepthTracks> depths;
  std::vector<ActuatorTracks> actuators;
  std::vector<AttitudeTracks> compasses;
};

/// The vehicle at the time that is tested now, as far as sound devices tell it.
struct Moment {
  Stamp at{};
  double dt = 0;
  std::optional<Eigen::Vector3d> down{};         ///< direction of gravity, body
  std::optional<Eigen::Vector3d> rate{};         ///< rad/s, body
  double heading = 0;                            ///< rad, from any zero; 0 if nothing tells it
  std::optional<Eigen::Vector2d> over_ground{};  ///< m/s, along and across, level
  std::optional<Eigen::Vector2d> along_deck{};   ///< m/s, body x and y
  Devices level_from{};                          ///< the device that told down and rate
  double level_sigma_rad = 0;                    ///< of `down`, if no velocity helps to find it
  bool heading_known = false;
  bool rate_lost = false;  ///< the rig has inertial units, and none tells the rate now
};

/// Within 60 degrees of level. A vehicle that rolls over or stands on its tail has no heading.
inline bool is_upright(const Moment& moment) { return !moment.down || moment.down->z() > 0.5; }

/// Velocity of the vehicle's origin from that of a sensor at `lever_arm_m`: v - w x r.
inline Eigen::Vector3d at_origin(const Eigen::Vector3d& velocity,
                                 const Eigen::Vector3d& lever_arm_m, const Moment& moment) {
  return moment.rate ? Eigen::Vector3d(velocity - moment.rate->cross(lever_arm_m)) : velocity;
}

/// 1 sigma of what at_origin() cannot take off while no unit tells how the vehicle turns, m/s. A
/// rig that never knew it has learned so.
inline double lever_sigma(const Eigen::Vector3d& lever_arm_m, const Moment& moment) {
  constexpr double usual_rate_radps = 0.1;
  return moment.rate_lost ? usual_rate_radps * lever_arm_m.norm() : 0;
}

/// Along and across of a body vector, in the horizontal plane.
inline Eigen::Vector2d levelled(const Eigen::Vector3d& body, const Moment& moment) {
  if (!moment.down) return body.head<2>();
  const Eigen::Vector3d& down = *moment.down;
  const Eigen::Vector3d ahead = (Eigen::Vector3d::UnitX() - down.x() * down).normalized();
  return {body.dot(ahead), body.dot(down.cross(ahead))};
}

}  // namespace drydock::consistency
