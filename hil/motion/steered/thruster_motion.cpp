#include "hil/motion/steered/thruster_motion.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/frame/earth.hpp"
#include "hil/motion/steered/steered_vehicle.hpp"
#include "hil/motion/vehicle/contact.hpp"
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

ThrusterMotion::ThrusterMotion(const rig_config::MissionConfig& mission)
    : ocean_(mission.ocean, {mission.latitude_rad, mission.longitude_rad, 0}),
      hull_(mission.thruster_vehicle.value()),
      first_{first_state(mission), {}},
      shafts_known_(std::ranges::all_of(mission.thruster_vehicle->thrusters,
                                        [](const auto& one) { return one.limit_radps > 0; })) {
  for (const auto& thruster : mission.thruster_vehicle->thrusters)
    thrusters_.emplace_back(thruster);
  first_.thrusters.resize(thrusters_.size());
}

hydrodynamics::Wrench ThrusterMotion::wrench(const Runs& runs) const {
  hydrodynamics::Wrench sum = hydrodynamics::Wrench::Zero();
  for (std::size_t i = 0; i < thrusters_.size(); ++i)
    sum += runs[i].push_n * thrusters_[i].of_one_newton();
  return sum;
}

VehicleRate ThrusterMotion::rate(const VehicleState& s, const hydrodynamics::Wrench& wrench,
                                 double t_s) const {
  const Eigen::Matrix3d body_to_ned = s.body_to_ned.toRotationMatrix();
  const Eigen::Vector3d omega = s.velocity.tail<3>(), through_water = s.velocity.head<3>();
  VehicleRate rate;
  rate.velocity_ned = ocean_.current_ned(-s.height_m, t_s) + body_to_ned * through_water;
  rate.attitude =
      (s.body_to_ned * Eigen::Quaterniond{0, omega.x(), omega.y(), omega.z()}).coeffs() / 2;
  rate.velocity = hull_.acceleration(s.velocity, body_to_ned, s.height_m, wrench);
  add_contact(s, ocean_, t_s, rate);
  return rate;
}

ThrusterState ThrusterMotion::after(const ThrusterState& state, std::span<const double> outputs,
                                    double t_s, double dt) const {
  ThrusterState now = state;
  const double steps = std::ceil(dt / longest_step_s - 1e-9), h = dt / steps;
  for (int i = 0; i < static_cast<int>(steps); ++i) short_step(now, outputs, t_s + i * h, h);
  return now;
}

void ThrusterMotion::drive(Runs& runs, std::span<const double> outputs, double dt) const {
  for (std::size_t i = 0; i < thrusters_.size(); ++i)
    runs[i] = thrusters_[i].after(runs[i], i < outputs.size() ? outputs[i] : 0, dt);
}

/// The thrusters of the middle of the step hold for all of it.
void ThrusterMotion::short_step(ThrusterState& state, std::span<const double> outputs, double t_s,
                                double h) const {
  drive(state.thrusters, outputs, h / 2);
  const hydrodynamics::Wrench push = wrench(state.thrusters);
  VehicleState& s = state.vehicle;
  const VehicleRate k1 = rate(s, push, t_s), k2 = rate(moved(s, k1, h / 2), push, t_s),
                    k3 = rate(moved(s, k2, h / 2), push, t_s),
                    k4 = rate(moved(s, k3, h), push, t_s);
  s = moved(s, mean(k1, k2, k3, k4), h);
  s.body_to_ned.normalize();
  keep_in_water(s, ocean_);
  drive(state.thrusters, outputs, h / 2);
}

Truth ThrusterMotion::truth(const ThrusterState& state, double t_s) const {
  const VehicleState& s = state.vehicle;
  const VehicleRate now = rate(s, wrench(state.thrusters), t_s);
  Truth truth = truth_of(s, now, acceleration_ned(s, now, ocean_, t_s), ocean_, t_s);
  if (shafts_known_)
    for (std::size_t i = 0; i < thrusters_.size(); ++i)
      truth.thruster_radps.push_back(thrusters_[i].shaft_radps(state.thrusters[i]));
  return truth;
}

}  // namespace drydock::motion
