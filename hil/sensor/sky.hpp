#pragma once

#include "drivers/measurement/measurement.hpp"
#include "hil/motion/truth.hpp"

namespace drydock::sensor {

/// Where an emulated receiver's satellites come from. May hold noise: one for each receiver, asked
/// in time order.
class Sky {
 public:
  virtual ~Sky() = default;

  /// What a receiver whose antenna is out of the water says of the satellites above its mask. One
  /// it knows of but does not track has no C/N0.
  virtual measurement::GnssSatellites at(const motion::Truth& truth) = 0;
};

/// A synthetic sky of ten GPS satellites whose azimuth and elevation drift slowly, with C/N0 from
/// elevation. It has the shape of a real sky and the rates of a real one, but it is nobody's
/// almanac: positions are not solved from it. Empty under water.
measurement::GnssSatellites ideal_sky(const motion::Truth& truth, bool under_water);

/// `ideal_sky` as a source: what a receiver has when no ephemeris is named.
class InventedSky final : public Sky {
 public:
  measurement::GnssSatellites at(const motion::Truth& truth) override {
    return ideal_sky(truth, false);
  }
};

}  // namespace drydock::sensor
