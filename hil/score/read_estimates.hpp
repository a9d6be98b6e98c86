#pragma once

#include <boost/system/result.hpp>
#include <istream>
#include <string>

#include "estimators/frame/geodetic.hpp"
#include "hil/score/track.hpp"

namespace drydock::score {

/// Lines `t x y z qx qy qz qw`: seconds, metres, a quaternion with its scalar last; axes east,
/// north, up, body forward, left, up, as ROS has them. # begins a comment. `name` is for
/// problems.
boost::system::result<Estimates, Problem> read_tum(std::istream& in, const std::string& name);

/// A first line with names of columns, in any order: `t_s` or `valid_at_ns`; `latitude_deg`,
/// `longitude_deg`, `height_m` or `north_m`, `east_m`, `down_m`; if there are any, `roll_deg`,
/// `pitch_deg`, `heading_deg` and `north_sigma_m`, `east_sigma_m`, `down_sigma_m`. Places count
/// from `origin`.
boost::system::result<Estimates, Problem> read_csv(std::istream& in, const std::string& name,
                                                   const frame::Position& origin);

/// A topic of nav_msgs/Odometry of an MCAP file; empty: its only one.
boost::system::result<Estimates, Problem> read_odometry(const std::string& path,
                                                        const std::string& topic);

}  // namespace drydock::score
