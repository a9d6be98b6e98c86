#pragma once

#include <boost/system/result.hpp>
#include <istream>
#include <string>

#include "estimators/frame/geodetic.hpp"
#include "hil/score/track.hpp"

namespace drydock::score {

/// How many numbers a line of KITTI's poses has.
inline constexpr std::size_t kitti_numbers = 12;

/// Lines `t x y z qx qy qz qw`: seconds, metres, a quaternion with its scalar last; axes east,
/// north, up, body forward, left, up, as ROS has them. # begins a comment. `name` is for
/// problems.
boost::system::result<Estimates, Problem> read_tum(std::istream& in, const std::string& name);

/// Lines of 12 numbers, a 3 x 4 matrix by rows, from a camera (right, down, forward) to its first
/// pose: north is taken to be ahead in that one. Their times are the lines of another file.
boost::system::result<Estimates, Problem> read_kitti(std::istream& in, const std::string& name,
                                                     const std::string& times_path);

/// The points of a track (`trkpt`) that have a time. Their height (`ele`) is taken as one of
/// WGS-84, as `drydock track` writes it.
boost::system::result<Estimates, Problem> read_gpx(std::istream& in, const std::string& name,
                                                   const frame::Position& origin);

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
