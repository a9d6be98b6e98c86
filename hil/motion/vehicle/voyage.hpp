#pragma once

#include <cstdint>
#include <list>
#include <mutex>
#include <vector>

#include "hil/motion/vehicle/helm.hpp"

namespace drydock::motion {

/// A vehicle at one step, with the command until the next step.
struct VoyageStep {
  VehicleState state;
  VehicleRate rate;
  Actuators actuators;
  AutopilotMemory memory;
  Command command;
};

/// What a vehicle does at the surface and at the bed.
enum class Edges : std::uint8_t {
  open,   ///< nothing: its plan stays in the water
  closed  ///< it cannot leave the water, sink into the bed, or leave its equations
};

/// The steps of a vehicle under a helm. Any step can be requested, in
/// any order and from any thread, with the same bits each time. The first step of every block is
/// kept, and all steps of the few blocks that were used last.
class Voyage {
 public:
  /// Begins where the mission does, at its speed. The helm must outlive the voyage. Throws
  /// std::invalid_argument for a vehicle that is not possible.
  Voyage(const rig_config::MissionConfig& mission, const Helm& helm, Edges edges);

  VoyageStep at(std::int64_t step) const;  ///< from 0 on

  const VehicleMotion& motion() const { return motion_; }

 private:
  struct Block {
    std::int64_t index = 0;
    std::vector<VoyageStep> steps;
  };

  VoyageStep first(const rig_config::MissionConfig& mission) const;
  VoyageStep after(const VoyageStep& step, std::int64_t index) const;
  void complete(VoyageStep& step, std::int64_t index) const;
  void keep_in_reach(const VehicleState& before, VehicleState& now) const;
  Block& block(std::int64_t index) const;
  void extend(Block& block, std::size_t steps) const;

  VehicleMotion motion_;
  const Helm& helm_;
  Edges edges_;
  mutable std::mutex mutex_;
  mutable std::vector<VoyageStep> starts_;  ///< first steps of the blocks that were requested so
                                            ///< far
  mutable std::list<Block> blocks_;         ///< the most recently used first
};

}  // namespace drydock::motion
