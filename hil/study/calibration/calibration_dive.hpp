#pragma once

#include <cstdint>

#include "estimators/calibration/parameter.hpp"
#include "estimators/smoothing/level_filter.hpp"
#include "hil/motion/truth.hpp"

/// Emulated dives of the calibration study: a DVL, a compass, a depth sensor and a GNSS receiver on
/// one vehicle, whose errors are drawn.
namespace drydock::study {

/// One sensor of each kind, by index of its device.
enum CalibrationDevice : std::uint16_t {
  dvl_of_dive,
  compass_of_dive,
  depth_of_dive,
  gnss_of_dive
};

/// What is wrong in a dive; all zero: as the rig says.
struct CalibrationErrors {
  std::vector<calibration::Parameter> parameters;  ///< all that the study looks for
  std::vector<double> values;                      ///< their true values
  double heading_bias_rad = 0;
};

/// Draws the errors of a run: yaw 2 deg, pitch 1 deg, scale 1.5 %, latencies .1 s, levers .3 m,
/// deviation 1 deg, each 1 sigma.
CalibrationErrors drawn_errors(std::uint64_t seed, std::size_t run);
/// No error but a bias of the compass, 1 sigma 1 degree.
CalibrationErrors drawn_bias(std::uint64_t seed, std::size_t run);

/// The 17 minutes that all dives sail: a circle at the surface, legs and turns at two speeds 20 m
/// down, and a half circle at the surface.
const motion::Trajectory& calibration_trajectory();

/// Its readings, one of each sensor in 2 s, with the noise of a run: DVL 1 cm/s, heading and tilt
/// .3 and .1 degree, depth 5 cm, fixes 1 m.
smoothing::Dive calibration_dive(const CalibrationErrors& errors, std::uint64_t seed,
                                 std::size_t run);

/// What is known of such a dive: levers as the rig has them.
smoothing::LevelOptions calibration_options(const smoothing::Dive& dive);

}  // namespace drydock::study
