#pragma once

#include <boost/system/result.hpp>
#include <string>

#include "estimators/frame/geodetic.hpp"
#include "hil/score/track.hpp"

namespace drydock::score {

struct Truth {
  frame::Position origin;  ///< of the track's positions: the first place
  Track track;
  std::string damage;  ///< one line, if the recording is truncated or damaged
};

/// The truth of a recording of an emulated vehicle (MCAP).
boost::system::result<Truth, Problem> read_truth(const std::string& path);

}  // namespace drydock::score
