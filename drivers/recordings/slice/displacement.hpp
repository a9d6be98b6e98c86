#pragma once

#include <map>
#include <optional>
#include <string>

#include "drivers/measurement/measurement.hpp"

namespace drydock::slice {

/// Moves a track to another place on the WGS-84 ellipsoid. The distances north and east between its
/// points stay the same, in metres. Latitudes and longitudes move independently of each other.
class Displacement {
 public:
  explicit Displacement(const measurement::Geodetic& to);

  /// `from` is the point that moves to `to`: the first point. Later calls change nothing.
  void start_at(const measurement::Geodetic& from);
  const std::optional<measurement::Geodetic>& start() const { return from_; }

  /// rad. Before start_at() every point becomes `to`.
  double latitude(double latitude_rad) const;
  double longitude(double longitude_rad) const;
  measurement::Geodetic operator()(const measurement::Geodetic& position) const {
    return {latitude(position.latitude_rad), longitude(position.longitude_rad)};
  }

 private:
  measurement::Geodetic to_;
  std::optional<measurement::Geodetic> from_;
  double north_scale_ = 1, east_scale_ = 1;  ///< radians at the new place for one radian at the old
};

/// Counts by name the data that were dropped because they show the place.
using Dropped = std::map<std::string, std::uint64_t>;

}  // namespace drydock::slice
