#include "hil/motion/steered/thruster_vehicle.hpp"

#include <cmath>

#include "estimators/frame/earth.hpp"
#include "hil/motion/vehicle/keep_in_water.hpp"
#include "hil/motion/vehicle/vehicle_truth.hpp"

namespace drydock::motion {
namespace {

constexpr double longest_step_s = 0.0025;

VehicleState moved(const VehicleState& from, const VehicleRate& rate, double by) {
  VehicleState to = from;
  const Eigen::Vector3d way = by * rate.velocity_ned;
  to.height_m -= way.z();
  to.latitude_rad += way.x() / (frame::meridian_radius(from.latitude_rad) + from.height_m);
  to.longitude_rad += way.y() / ((frame::transverse_radius(from.latitude_rad) + from.height_m) *
                                 std::cos(from.latitude_rad));
  to.body_to_ned.coeffs() += by * rate.attitude;
  to.velocity += by * rate.velocity;
  return to;
}

VehicleRate mean(const VehicleRate& k1, const VehicleRate& k2, const VehicleRate& k3,
                 const VehicleRate& k4) {
  return {(k1.velocity_ned + 2 * (k2.velocity_ned + k3.velocity_ned) + k4.velocity_ned) / 6,
          (k1.attitude + 2 * (k2.attitude + k3.attitude) + k4.attitude) / 6,
          (k1.velocity + 2 * (k2.velocity + k3.velocity) + k4.velocity) / 6};
}

}  // namespace

ThrusterVehicle::ThrusterVehicle(const rig_config::MissionConfig& mission)
    : ocean_(mission.ocean, {mission.latitude_rad, mission.longitude_rad, 0}),
      hull_(mission.thruster_vehicle.value()),
      state_(first_state(mission)) {
  for (const auto& thruster : mission.thruster_vehicle->thrusters)
    thrusters_.emplace_back(thruster);
}

hydrodynamics::Wrench ThrusterVehicle::wrench() const {
  hydrodynamics::Wrench sum = hydrodynamics::Wrench::Zero();
  for (const auto& thruster : thrusters_) sum += thruster.push_n() * thruster.of_one_newton();
  return sum;
}

VehicleRate ThrusterVehicle::rate(const VehicleState& s) const {
  const Eigen::Matrix3d body_to_ned = s.body_to_ned.toRotationMatrix();
  const Eigen::Vector3d omega = s.velocity.tail<3>(), through_water = s.velocity.head<3>();
  VehicleRate rate;
  rate.velocity_ned = ocean_.current_ned(-s.height_m, t_s_) + body_to_ned * through_water;
  rate.attitude =
      (s.body_to_ned * Eigen::Quaterniond{0, omega.x(), omega.y(), omega.z()}).coeffs() / 2;
  rate.velocity = hull_.acceleration(s.velocity, body_to_ned, s.height_m, wrench());
  return rate;
}

void ThrusterVehicle::step(std::span<const double> outputs, double dt) {
  const double steps = std::ceil(dt / longest_step_s - 1e-9);
  for (int i = 0; i < static_cast<int>(steps); ++i) short_step(outputs, dt / steps);
}

/// The thrusters of the middle of the step hold for all of it.
void ThrusterVehicle::short_step(std::span<const double> outputs, double h) {
  const auto drive = [&] {
    for (std::size_t i = 0; i < thrusters_.size(); ++i)
      thrusters_[i].step(i < outputs.size() ? outputs[i] : 0, h / 2);
  };
  drive();
  const VehicleRate k1 = rate(state_), k2 = rate(moved(state_, k1, h / 2)),
                    k3 = rate(moved(state_, k2, h / 2)), k4 = rate(moved(state_, k3, h));
  state_ = moved(state_, mean(k1, k2, k3, k4), h);
  state_.body_to_ned.normalize();
  keep_in_water(state_, ocean_);
  drive();
  t_s_ += h;
}

Truth ThrusterVehicle::truth() const {
  const VehicleRate now = rate(state_);
  const Eigen::Vector3d v = state_.velocity.head<3>(), omega = state_.velocity.tail<3>();
  const Eigen::Vector3d acceleration_ned =
      state_.body_to_ned * (now.velocity.head<3>() + omega.cross(v)) +
      ocean_.current_rate_ned(-state_.height_m, now.velocity_ned.z(), t_s_);
  return truth_of(state_, now, acceleration_ned, ocean_, t_s_);
}

}  // namespace drydock::motion
