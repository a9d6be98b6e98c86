#pragma once

#include "estimators/hydrodynamics/vehicle.hpp"
#include "rig_config/thruster_vehicle.hpp"

namespace drydock::motion {

/// One thruster of a vehicle. Its push follows the curve of its command with a first-order lag. It
/// does not depend on the speed through the water.
class Thruster {
 public:
  explicit Thruster(const rig_config::ThrusterConfig& config);

  /// Advances by dt seconds with a held command, -1 (full astern) to 1 (full ahead).
  void step(double command, double dt);

  /// The push that the command gives in the end, N.
  double steady_push_n(double command) const;
  /// The command that gives this push in the end, -1 to 1; 0 for a push of 0.
  double command_for(double push_n) const;
  /// The most that it pushes in the direction of this push, N; positive.
  double limit_n(double push_n) const { return push_n > 0 ? config_.ahead_n : config_.astern_n; }
  double push_n() const { return push_n_; }
  /// Force and moment of a push of 1 N, body axes.
  const hydrodynamics::Wrench& of_one_newton() const { return of_one_newton_; }

 private:
  rig_config::ThrusterConfig config_;
  hydrodynamics::Wrench of_one_newton_;
  double push_n_ = 0;
};

}  // namespace drydock::motion
