#pragma once

#include <cmath>

#include "estimators/frame/geodetic.hpp"
#include "hil/score/track.hpp"

namespace drydock::score {

/// From the origin, NED, m. What is NaN in `place` is NaN here: a place without a height is taken
/// at the origin's, a height without a place is the difference of heights.
inline Eigen::Vector3d place_of(const frame::Position& place, const frame::Position& origin) {
  if (std::isnan(place.latitude_rad) || std::isnan(place.longitude_rad))
    return {untold().x(), untold().y(), origin.height_m - place.height_m};
  if (!std::isnan(place.height_m)) return frame::ned_offset(origin, place);
  auto offset =
      frame::ned_offset(origin, {place.latitude_rad, place.longitude_rad, origin.height_m});
  offset.z() = place.height_m;
  return offset;
}

}  // namespace drydock::score
