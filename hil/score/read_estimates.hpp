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

/// A first line with names of columns, in any order: csv_head.hpp has them. Needed are a time, and
/// a column of a position, an attitude or a velocity. Places count from `origin`.
boost::system::result<Estimates, Problem> read_csv(std::istream& in, const std::string& name,
                                                   const frame::Position& origin);

/// A topic of an MCAP file, of a type in message_state.hpp; empty: the only one that gives
/// estimates. Places in degrees count from `origin`.
boost::system::result<Estimates, Problem> read_mcap(const std::string& path,
                                                    const std::string& topic,
                                                    const frame::Position& origin);

}  // namespace drydock::score
