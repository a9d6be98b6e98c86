#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "hil/motion/splined/pose.hpp"

namespace drydock::motion {

/// `FILE:LINE: what is wrong, what is allowed`.
struct BadPoses : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// CSV. The first line names the columns, in any order; others are passed over: the time `time_s`;
/// `latitude_deg`, `longitude_deg` (WGS-84) and `height_m` or `depth_m`, or `north_m`, `east_m`,
/// `down_m` from `origin`; `roll_deg`, `pitch_deg`, `heading_deg`, or the quaternion body to NED
/// `qw`, `qx`, `qy`, `qz`. Two lines at least, times rising. `file` is its name in errors. Throws
/// BadPoses.
Poses parse_poses(std::string_view text, const std::string& file, const frame::Position& origin);

/// The same from a file.
Poses read_poses(const std::string& file, const frame::Position& origin);

}  // namespace drydock::motion
