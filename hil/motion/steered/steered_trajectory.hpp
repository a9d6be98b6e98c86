#pragma once

#include <mutex>
#include <vector>

#include "hil/motion/steered/steered_vehicle.hpp"

namespace drydock::motion {

/// The motion of a vehicle that another program steers step by step. That program's clock advances
/// with its steps; sensors ask for bench time. The two run side by side: a motion that is not there
/// yet is the last one, and if the program stood still or ran ahead by more than 100 ms, the motion
/// stands still or jumps in bench time, which is counted.
class SteeredTrajectory final : public Trajectory {
 public:
  /// Throws as make_steered_vehicle().
  SteeredTrajectory(const rig_config::MissionConfig& mission, Stamp start);

  /// Advances the vehicle by dt seconds; `now` is bench time.
  void step(std::span<const double> outputs, double dt, Stamp now);

  Truth latest() const;
  double motion_s() const;      ///< time of the motion since its first step
  std::uint64_t waits() const;  ///< how often the motion stood still in bench time
  std::uint64_t jumps() const;  ///< how often it jumped ahead

  Truth at(Stamp time) const override;
  Stamp start() const override { return start_; }
  Stamp end() const override { return start_; }  ///< it has no end of its own
  const ocean::Ocean& ocean() const override { return vehicle_->ocean(); }

 private:
  struct Moment {
    double motion_s;
    Truth truth;
  };

  void keep_beside(Stamp now);
  const Moment& moment(std::size_t age) const;

  Stamp start_;
  std::unique_ptr<SteeredVehicle> vehicle_;
  mutable std::mutex mutex_;
  std::vector<Moment> past_;  ///< a ring
  std::size_t newest_ = 0;
  Stamp begin_{};  ///< bench time at which the motion began
  bool began_ = false;
  std::uint64_t waits_ = 0, jumps_ = 0;
};

/// Null: nobody steers this motion.
inline SteeredTrajectory* steered(Trajectory& motion) {
  return dynamic_cast<SteeredTrajectory*>(&motion);
}

}  // namespace drydock::motion
