#pragma once

#include "estimators/hydrodynamics/vehicle.hpp"
#include "rig_config/thruster_vehicle.hpp"

namespace drydock::motion {

/// How one thruster runs.
struct ThrusterRun {
  double push_n = 0;
  double command = 0;  ///< that its shaft follows so far, -1 (full astern) to 1 (full ahead)
};

/// The law of one thruster. Its push follows the curve of its command with a first-order lag, and
/// so does its shaft the command. It does not depend on the speed through the water.
class Thruster {
 public:
  explicit Thruster(const rig_config::ThrusterConfig& config);

  /// dt seconds later, with a held command.
  ThrusterRun after(const ThrusterRun& run, double command, double dt) const;

  /// The push that the command gives in the end, N.
  double steady_push_n(double command) const;
  /// The command that gives this push in the end, -1 to 1; 0 for a push of 0.
  double command_for(double push_n) const;
  /// The most that it pushes in the direction of this push, N; positive.
  double limit_n(double push_n) const { return push_n > 0 ? config_.ahead_n : config_.astern_n; }
  /// Turns of the shaft, rad/s: in proportion to the command.
  double shaft_radps(const ThrusterRun& run) const { return run.command * config_.limit_radps; }
  /// Force and moment of a push of 1 N, body axes.
  const hydrodynamics::Wrench& of_one_newton() const { return of_one_newton_; }

 private:
  rig_config::ThrusterConfig config_;
  hydrodynamics::Wrench of_one_newton_;
};

}  // namespace drydock::motion
