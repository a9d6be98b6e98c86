#pragma once

#include <optional>
#include <span>

#include "hil/motion/truth.hpp"
#include "hil/twin/keeper.hpp"
#include "rig_config/rig.hpp"

namespace drydock::twin {

/// What the sensors tell of the water and the bed.
struct Surroundings {
  std::optional<double> bed_depth_m;              ///< median of the soundings; empty: none
  double bed_scatter_m = 0;                       ///< half of the soundings are nearer than this
  std::optional<Eigen::Vector2d> current_ne_mps;  ///< mean; empty: no log, or too few headings
};

Surroundings surroundings_of(const ByDevice& measured, const rig_config::Rig& rig,
                             const motion::Trajectory& track);

/// The depth of the bed under the track at these times (s since its start), as the soundings tell
/// it: means over four minutes, the nearest at the centre weighing most; on a line across times
/// without any. Empty: there are none.
std::vector<double> bed_along(const ByDevice& measured, const rig_config::Rig& rig,
                              const motion::Trajectory& track, std::span<const double> times_s);

/// The same as the ocean of a mission. The bed lies below the deepest point of the track.
rig_config::OceanConfig ocean_of(const Surroundings& surroundings, double deepest_m);

}  // namespace drydock::twin
