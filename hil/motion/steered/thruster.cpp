#include "hil/motion/steered/thruster.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace drydock::motion {

Thruster::Thruster(const rig_config::ThrusterConfig& config) : config_(config) {
  const Eigen::Vector3d place(config.position_m.data());
  const Eigen::Vector3d direction = Eigen::Vector3d(config.direction.data()).normalized();
  of_one_newton_ << direction, place.cross(direction);
}

double Thruster::steady_push_n(double command) const {
  const double size = std::min(std::abs(command), 1.0);
  const double beyond = (size - config_.dead_band) / (1 - config_.dead_band);
  if (beyond <= 0) return 0;
  const double share = std::pow(beyond, config_.exponent);
  return command > 0 ? share * config_.ahead_n : -share * config_.astern_n;
}

double Thruster::command_for(double push_n) const {
  if (push_n == 0) return 0;
  const double share = std::min(std::abs(push_n) / limit_n(push_n), 1.0);
  const double size =
      config_.dead_band + (1 - config_.dead_band) * std::pow(share, 1 / config_.exponent);
  return std::copysign(size, push_n);
}

ThrusterRun Thruster::after(const ThrusterRun& run, double command, double dt) const {
  const double kept = config_.lag_s > 0 ? std::exp(-dt / config_.lag_s) : 0;
  const double push_n = steady_push_n(command), turns = std::clamp(command, -1.0, 1.0);
  return {push_n + (run.push_n - push_n) * kept, turns + (run.command - turns) * kept};
}

}  // namespace drydock::motion
