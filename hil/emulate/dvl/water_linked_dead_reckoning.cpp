#include "hil/emulate/dvl/water_linked_dead_reckoning.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/geodetic.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {
namespace {

/// A guess: what a small inertial sensor does to a velocity that nothing measures.
constexpr double acceleration_deviation_mps2 = 0.05;

Eigen::Matrix3d head_to_ned(const motion::Truth& truth, const sensor::Mounting& mounting) {
  return truth.body_to_ned * mounting.sensor_to_body;
}

}  // namespace

void WaterLinkedDeadReckoning::reset(const motion::Truth& truth, const sensor::Mounting& mounting) {
  origin_ = truth;
  origin_to_ned_ = head_to_ned(truth, mounting);
  variance_m2_ = without_velocity_s_ = 0;
}

void WaterLinkedDeadReckoning::note_velocity(std::optional<double> figure_of_merit_mps,
                                             double interval_s) {
  without_velocity_s_ = figure_of_merit_mps ? 0 : without_velocity_s_ + interval_s;
  const double deviation_mps =
      figure_of_merit_mps.value_or(acceleration_deviation_mps2 * without_velocity_s_);
  variance_m2_ += std::pow(deviation_mps * interval_s, 2);
}

std::optional<wire::water_linked_json::Position> WaterLinkedDeadReckoning::at(
    const motion::Truth& truth, const sensor::Mounting& mounting, double turned_rad) const {
  if (!origin_) return std::nullopt;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(turned_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Matrix3d to_origin = turn * origin_to_ned_.transpose();
  const Eigen::Vector3d way =
      to_origin * frame::ned_offset(place_of(*origin_, mounting), place_of(truth, mounting));
  const Eigen::Matrix3d attitude = to_origin * head_to_ned(truth, mounting) * turn.transpose();
  const frame::Euler angles = frame::euler(Eigen::Matrix3d(attitude.transpose()));
  wire::water_linked_json::Position position;
  position.position_m = {way.x(), way.y(), way.z()};
  position.position_deviation_m = std::sqrt(variance_m2_);
  position.roll_rad = angles.roll;
  position.pitch_rad = angles.pitch;
  position.yaw_rad = angles.yaw;
  return position;
}

}  // namespace drydock::emulate
