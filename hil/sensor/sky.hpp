#pragma once

#include "drivers/measurement/measurement.hpp"
#include "hil/motion/truth.hpp"

namespace drydock::sensor {

/// The source of an emulated receiver's satellites. It may hold noise, so each receiver has its own
/// and asks in time order.
class Sky {
 public:
  virtual ~Sky() = default;

  /// The satellites above the mask, for a receiver whose antenna is above the water. A satellite
  /// that is known but not tracked has no C/N0.
  virtual measurement::GnssSatellites at(const motion::Truth& truth) = 0;
};

/// A synthetic sky of ten GPS satellites with slowly drifting azimuth and elevation and C/N0 from
/// elevation. Its shape and rates are realistic, but it follows no almanac: no position can be
/// solved from it. Empty under water.
measurement::GnssSatellites ideal_sky(const motion::Truth& truth, bool under_water);

/// `ideal_sky` as a source, for a receiver without an ephemeris.
class InventedSky final : public Sky {
 public:
  measurement::GnssSatellites at(const motion::Truth& truth) override {
    return ideal_sky(truth, false);
  }
};

}  // namespace drydock::sensor
