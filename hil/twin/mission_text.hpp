#pragma once

#include <string>

#include "hil/motion/splined/pose.hpp"
#include "rig_config/ocean.hpp"

namespace drydock::twin {

/// A file of poses: what motion::parse_poses reads.
std::string poses_text(const motion::Poses& poses);

/// A mission file that sails the poses of `track.csv` beside it.
std::string mission_text(const motion::Poses& poses, const rig_config::OceanConfig& ocean,
                         const std::string& source);

}  // namespace drydock::twin
