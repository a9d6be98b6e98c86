#pragma once

#include "drivers/measurement/measurement.hpp"
#include "hil/motion/truth.hpp"

namespace drydock::sensor {

/// A synthetic sky of ten GPS satellites whose azimuth and elevation drift slowly, with C/N0 from
/// elevation. It has the shape of a real sky and the rates of a real one, but it is nobody's
/// almanac: positions are not solved from it. Empty under water.
measurement::GnssSatellites ideal_sky(const motion::Truth& truth, bool under_water);

}  // namespace drydock::sensor
