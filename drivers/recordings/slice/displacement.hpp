#pragma once

#include <map>
#include <optional>
#include <string>

#include "drivers/measurement/measurement.hpp"

namespace drydock::slice {

/// Puts a track somewhere else on the WGS-84 ellipsoid: metres north and east between its points
/// stay what they were there. Latitudes and longitudes move independently of each other.
class Displacement {
 public:
  explicit Displacement(const measurement::Geodetic& to);

  /// The point that will become `to`: the first that is seen. Later calls change nothing.
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
  double north_scale_ = 1, east_scale_ = 1;  ///< radians there for a radian here
};

/// How many of what were given up since they tell the place.
using Dropped = std::map<std::string, std::uint64_t>;

}  // namespace drydock::slice
