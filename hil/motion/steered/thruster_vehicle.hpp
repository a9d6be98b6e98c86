#pragma once

#include "hil/motion/steered/steered_vehicle.hpp"
#include "hil/motion/steered/thruster_motion.hpp"

namespace drydock::motion {

/// A vehicle with thrusters that another program steers by their outputs.
class ThrusterVehicle final : public SteeredVehicle {
 public:
  /// `mission.thruster_vehicle` must be set.
  explicit ThrusterVehicle(const rig_config::MissionConfig& mission)
      : motion_(mission), state_(motion_.first()) {}

  void step(std::span<const double> outputs, double dt) override {
    state_ = motion_.after(state_, outputs, t_s_, dt);
    t_s_ += dt;
  }
  Truth truth() const override { return motion_.truth(state_, t_s_); }
  const ocean::Ocean& ocean() const override { return motion_.ocean(); }

 private:
  ThrusterMotion motion_;
  ThrusterState state_;
  double t_s_ = 0;
};

}  // namespace drydock::motion
