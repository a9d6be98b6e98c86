#include "hil/sensor/ideal.hpp"

#include <cmath>
#include <numbers>

#include "drivers/measurement/actuator_order.hpp"
#include "estimators/frame/attitude.hpp"
#include "estimators/frame/geodetic.hpp"

namespace drydock::sensor {
namespace {

using Eigen::Vector3d;

measurement::Origin origin_at(Stamp at) {
  measurement::Origin origin;
  origin.valid_at = at;
  return origin;
}

Vector3d arm_ned(const Truth& truth, const Mounting& mounting) {
  return truth.body_to_ned * mounting.lever_arm_m;
}

Vector3d velocity_body_at(const Truth& truth, const Mounting& mounting) {
  return truth.velocity_body + truth.rate_body.cross(mounting.lever_arm_m);
}

/// d(angular rate)/dt, for a trajectory that does not give it.
Vector3d differenced_rate(const Trajectory& trajectory, Stamp at) {
  const auto h = std::chrono::milliseconds{1};
  return (trajectory.at(at + h).angular_rate - trajectory.at(at - h).angular_rate) /
         (2 * measurement::seconds(h));
}

}  // namespace

measurement::ImuSample ideal_imu(const Trajectory& trajectory, Stamp at, const Mounting& mounting) {
  const Truth truth = trajectory.at(at);
  measurement::ImuSample sample;
  sample.origin = origin_at(at);
  Vector3d force = truth.specific_force;
  const Vector3d& r = mounting.lever_arm_m;
  if (!r.isZero()) {
    const Vector3d acceleration =
        truth.angular_acceleration ? *truth.angular_acceleration : differenced_rate(trajectory, at);
    const Vector3d& w = truth.angular_rate;
    force += w.cross(w.cross(r)) + acceleration.cross(r);
  }
  sample.specific_force = mounting.to_sensor(force);
  sample.angular_rate = mounting.to_sensor(truth.angular_rate);
  return sample;
}

Vector3d velocity_at(const Truth& truth, const Mounting& mounting) {
  return mounting.to_sensor(velocity_body_at(truth, mounting));
}

double depth_at(const Truth& truth, const Mounting& mounting) {
  return arm_ned(truth, mounting).z() - truth.height_m;
}

frame::Position place_of(const Truth& truth, const Mounting& mounting) {
  const frame::Position origin{truth.latitude_rad, truth.longitude_rad, truth.height_m};
  if (mounting.lever_arm_m.isZero()) return origin;
  return frame::at_ned_offset(origin, arm_ned(truth, mounting));
}

double altitude_at(const Truth& truth, const ocean::Ocean& ocean, const Mounting& mounting) {
  const frame::Position place = place_of(truth, mounting);
  return ocean.bed_depth_m(place.latitude_rad, place.longitude_rad) + place.height_m;
}

measurement::WaterSpeed ideal_log(const Trajectory& trajectory, Stamp at,
                                  const Mounting& mounting) {
  const Truth truth = trajectory.at(at);
  const Vector3d current_ned = trajectory.ocean().current_ned(
      depth_at(truth, mounting), measurement::seconds(at - trajectory.start()));
  const Vector3d current_body = truth.body_to_ned.conjugate() * current_ned;
  const Vector3d through_water =
      mounting.to_sensor(velocity_body_at(truth, mounting) - current_body);
  measurement::WaterSpeed sample;
  sample.origin = origin_at(truth.at);
  sample.longitudinal_mps = through_water.x();
  sample.transverse_mps = through_water.y();
  return sample;
}

measurement::GnssFix ideal_gnss(const Truth& truth, const Mounting& mounting) {
  measurement::GnssFix fix;
  fix.origin = origin_at(truth.at);
  fix.utc = truth.at;
  if (depth_at(truth, mounting) > antenna_awash_depth_m) return fix;
  const frame::Position antenna = place_of(truth, mounting);
  fix.type = measurement::FixType::three_d;
  fix.position = measurement::Geodetic{antenna.latitude_rad, antenna.longitude_rad};
  fix.ellipsoidal_height_m = antenna.height_m;
  fix.mean_sea_level_height_m = antenna.height_m;
  fix.velocity_ned = truth.body_to_ned * velocity_body_at(truth, mounting);
  return fix;
}

measurement::DepthSample ideal_depth(const Truth& truth, const ocean::Ocean& ocean,
                                     const Mounting& mounting) {
  measurement::DepthSample sample;
  sample.origin = origin_at(truth.at);
  sample.depth_m = depth_at(truth, mounting);
  sample.pressure_pa = ocean.pressure_pa(*sample.depth_m, truth.latitude_rad);
  sample.temperature_k = ocean.temperature_k();
  return sample;
}

measurement::ActuatorState ideal_actuators(const Truth& truth) {
  measurement::ActuatorState state;
  state.origin = origin_at(truth.at);
  state.rudder_rad = truth.rudder_rad;
  state.stern_plane_rad = truth.stern_plane_rad;
  state.bow_plane_rad = truth.bow_plane_rad;
  state.propeller_radps = truth.propeller_radps;
  return state;
}

double ideal_shaft(const Truth& truth, int actuator) {
  if (actuator == measurement::propeller_number) return truth.propeller_radps;
  return truth.thruster_radps.at(
      static_cast<std::size_t>(actuator - measurement::first_thruster_number));
}

measurement::AttitudeSample ideal_attitude(const Truth& truth, const Mounting& mounting) {
  const Eigen::Quaterniond sensor_to_ned =
      truth.body_to_ned * Eigen::Quaterniond(mounting.sensor_to_body);
  const frame::Euler angles = frame::euler(sensor_to_ned);
  measurement::AttitudeSample sample;
  sample.origin = origin_at(truth.at);
  sample.reference = measurement::HeadingReference::true_north;
  sample.heading_rad = angles.yaw < 0 ? angles.yaw + 2 * std::numbers::pi : angles.yaw;
  sample.true_heading_rad = sample.heading_rad;
  sample.roll_rad = angles.roll;
  sample.pitch_rad = angles.pitch;
  const frame::Euler body{truth.roll_rad, truth.pitch_rad, truth.yaw_rad};
  sample.rate_of_turn_radps = frame::euler_rates(body, truth.rate_body).z();
  return sample;
}

}  // namespace drydock::sensor
