#include "hil/motion/steered/fin_vehicle.hpp"

#include <algorithm>
#include <cmath>

#include "hil/motion/vehicle/keep_in_water.hpp"
#include "hil/motion/vehicle/vehicle_truth.hpp"

namespace drydock::motion {
namespace {

constexpr double longest_fin_step_s = 0.01;

double output(std::span<const double> outputs, std::size_t i) {
  return i < outputs.size() ? std::clamp(outputs[i], -1.0, 1.0) : 0;
}

}  // namespace

// Positive rudder turns to port, positive stern planes push the nose down, positive bow planes push
// it up.
FinShares fin_shares_of(std::span<const double> outputs) {
  const double starboard = output(outputs, 0), port = output(outputs, 1), down = output(outputs, 2);
  return {-(port - starboard) / 2, down, -down, std::max((port + starboard) / 2, 0.0)};
}

Command fins_of(std::span<const double> outputs, const rig_config::VehicleConfig& vehicle) {
  return fins_alone(fin_shares_of(outputs), vehicle);
}

Command fins_alone(std::span<const double> outputs, const rig_config::VehicleConfig& vehicle) {
  Command command;
  command.delta_r = output(outputs, 0) * vehicle.rudder.limit_rad;
  command.delta_s = output(outputs, 1) * vehicle.stern_planes.limit_rad;
  command.delta_b = output(outputs, 2) * vehicle.bow_planes.limit_rad;
  const double fastest = vehicle.propeller.advance_m * vehicle.propeller.limit_radps;
  command.speed_mps = std::max(output(outputs, 3), 0.0) * fastest;
  return command;
}

FinVehicle::FinVehicle(const rig_config::MissionConfig& mission, Mixing mixing)
    : config_(mission.vehicle.value()),
      mixing_(mixing),
      motion_(mission, Edges::closed),
      actuators_(config_, 0),
      state_(first_state(mission)) {}

void FinVehicle::step(std::span<const double> outputs, double dt) {
  const Command command = mixing_(outputs, config_);
  const double steps = std::ceil(dt / longest_fin_step_s - 1e-9), h = dt / steps;
  for (int i = 0; i < static_cast<int>(steps); ++i) {
    const VehicleRate rate = motion_.rate(state_, actuators_.control(), t_s_);
    state_ = motion_.step(state_, rate, actuators_, command, t_s_, h);
    keep_in_water(state_, motion_.ocean());
    t_s_ += h;
  }
}

Truth FinVehicle::truth() const {
  const auto control = actuators_.control();
  const VehicleRate rate = motion_.rate(state_, control, t_s_);
  Truth truth = truth_of(state_, rate, acceleration_ned(state_, rate, motion_.ocean(), t_s_),
                         motion_.ocean(), t_s_);
  truth.rudder_rad = control.delta_r;
  truth.stern_plane_rad = control.delta_s;
  truth.bow_plane_rad = control.delta_b;
  truth.propeller_radps = actuators_.propeller_radps();
  return truth;
}

}  // namespace drydock::motion
