#pragma once

#include <cstdint>
#include <vector>

#include "drivers/measurement/units.hpp"
#include "estimators/leveling/leveling_options.hpp"
#include "hil/study/leveling/leveling_motion.hpp"

/// One run of the leveling paper's experiment (its chapter 4).
namespace drydock::study {

inline constexpr double leveling_latitude_rad = 36 * units::degree;
inline constexpr double leveling_rate_hz = 100;
inline constexpr double leveling_duration_s = 30;
inline constexpr double leveling_point_spacing_s = 0.1;  ///< between points of the curves
inline constexpr std::size_t leveling_points = 301;      ///< 0, 0.1, ... 30 s

/// The origin of the biases of Table 1. The paper's means are possible only with one_sigma.
enum class LevelingBiases : std::uint8_t { one_sigma, drawn, none };

struct LevelingTrial {
  LevelingMotion motion;
  bool stationary = false;  ///< eq. (32) instead of eq. (29)
  LevelingBiases biases = LevelingBiases::one_sigma;
  std::uint64_t seed = 1;
  std::size_t run = 0;
};

/// The readings of one run with the errors of Table 1: biases and white noise per sample.
std::vector<LevelingReading> leveling_readings(const LevelingTrial& trial);

/// One filter in one run; degrees.
struct LevelingOutcome {
  std::vector<double> roll_error, pitch_error;        ///< estimate - truth, at `leveling_points`
  std::vector<double> roll_variance, pitch_variance;  ///< the filter's own, deg2
  double nees = 0;        ///< roll and pitch at the end, per state; 1 is consistent
  double settled_s = 0;   ///< both errors are below half a degree from this time on
  bool diverged = false;  ///< an error is above 5 degrees at the end
};

/// `options` are those of options_for(kind), possibly changed. The first guess of the attitude,
/// which is used only without accelerometer start, has an error of N(0, 45^2) degrees, not clipped.
LevelingOutcome run_leveling(const LevelingTrial& trial,
                             const std::vector<LevelingReading>& readings,
                             leveling::FilterKind kind, leveling::LevelingOptions options);

}  // namespace drydock::study
