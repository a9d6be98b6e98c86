#pragma once

#include <cstdint>
#include <list>
#include <mutex>
#include <vector>

#include "hil/motion/leg_profile.hpp"
#include "hil/motion/vehicle/autopilot.hpp"
#include "hil/motion/vehicle/vehicle_motion.hpp"

namespace drydock::motion {

inline constexpr std::int64_t voyage_step_ns = 10'000'000;
inline constexpr double voyage_step_s = 0.01;

/// A vehicle at one step, with the command until the next step.
struct VoyageStep {
  VehicleState state;
  VehicleRate rate;
  Actuators actuators;
  AutopilotMemory memory;
  Command command;
};

/// The steps of a vehicle that sails a mission with its autopilots. Any step can be requested, in
/// any order and from any thread, with the same bits each time. The first step of every block is
/// kept, and all steps of the few blocks that were used last.
class Voyage {
 public:
  /// Throws std::invalid_argument (one line) for a mission that the vehicle cannot sail.
  explicit Voyage(const rig_config::MissionConfig& mission);

  VoyageStep at(std::int64_t step) const;  ///< from 0 on

  const VehicleMotion& motion() const { return motion_; }
  double lap_s() const { return profile_.lap_s(); }

 private:
  struct Block {
    std::int64_t index = 0;
    std::vector<VoyageStep> steps;
  };

  void check_plan(const rig_config::MissionConfig& mission) const;
  VoyageStep first(const rig_config::MissionConfig& mission) const;
  VoyageStep after(const VoyageStep& step, std::int64_t index) const;
  void complete(VoyageStep& step, std::int64_t index) const;
  Block& block(std::int64_t index) const;
  void extend(Block& block, std::size_t steps) const;

  VehicleMotion motion_;
  MissionProfile profile_;
  Autopilot autopilot_;
  mutable std::mutex mutex_;
  mutable std::vector<VoyageStep> starts_;  ///< first steps of the blocks that were requested so
                                            ///< far
  mutable std::list<Block> blocks_;         ///< the most recently used first
};

}  // namespace drydock::motion
