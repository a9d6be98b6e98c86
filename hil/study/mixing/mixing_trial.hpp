#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "estimators/mixing/mixing_filter.hpp"
#include "rig_config/emulate.hpp"

/// One run of the fuzzy mixing paper's experiment (its chapter 4).
namespace drydock::study {

inline constexpr std::size_t mixing_rate_hz = 100, mixing_duration_s = 600;
inline constexpr double mixing_step_s = 1.0 / mixing_rate_hz;
inline constexpr std::size_t mixing_point_spacing = 10;  ///< steps between points of the curves
inline constexpr std::size_t mixing_points =
    mixing_duration_s * mixing_rate_hz / mixing_point_spacing;
inline constexpr double mixing_point_spacing_s = mixing_step_s * mixing_point_spacing;

/// The shipped files rig_config/missions/mixing-paper.toml and
/// rig_config/sensors/mixing-paper.toml.
std::string_view mixing_mission_text();
std::string_view mixing_sensors_text();

/// The sensor readings of one step: specific force, rate and speed ahead, all in its middle.
struct MixingReading {
  Eigen::Vector3d force, rate;
  double speed_mps, noisy_speed_mps;  ///< the second with 0.02 m/s of white noise
};

/// The truth, which is the same in every run, and the errors of the sensors.
struct MixingExperiment {
  MixingExperiment();

  struct Point {
    double north_m, east_m, depth_m, roll_rad, pitch_rad;
  };
  std::vector<MixingReading> ideal;  ///< one per step
  std::vector<Point> points;         ///< at the end of every `mixing_point_spacing`th step
  double latitude_rad, heading_rad, pivot_m;
  rig_config::EmulateConfig imu, log;
};

/// The readings of one run with the errors of Table 5.
std::vector<MixingReading> mixing_readings(const MixingExperiment& experiment, std::uint64_t seed,
                                           std::size_t run);

/// A variant to compare. `key` is its name in the JSON.
struct MixingVariant {
  std::string_view key;
  mixing::MixingType type;
  mixing::IntegralGain integral_gain = mixing::IntegralGain::k1_k2;
  bool as_printed = false;  ///< no low-pass on the inputs of the inference, sets without plateau
  bool noisy_log = false;
};

inline constexpr std::array<std::string_view, 4> mixing_types{"type1", "type2", "type3",
                                                              "compensated"};
/// The types with both readings of the integral gain, then further variants of the types.
inline constexpr std::array mixing_variants = [] {
  using enum mixing::MixingType;
  constexpr auto k2 = mixing::IntegralGain::k2_alone;
  constexpr auto k1_k2 = mixing::IntegralGain::k1_k2;
  return std::array<MixingVariant, 11>{{{"type1", fixed_gain},
                                        {"type2", fuzzy_inference},
                                        {"type3", gain_schedule},
                                        {"compensated", compensated},
                                        {"type1", fixed_gain, k2},
                                        {"type2", fuzzy_inference, k2},
                                        {"type3", gain_schedule, k2},
                                        {"compensated", compensated, k2},
                                        {"type2", fuzzy_inference, k1_k2, true},
                                        {"type3", gain_schedule, k1_k2, true},
                                        {"compensated", compensated, k1_k2, false, true}}};
}();

mixing::MixingOptions mixing_options(const MixingVariant& variant,
                                     const MixingExperiment& experiment);

/// Errors of roll and pitch at every point, in degrees. `nees` is the mean, over points and both
/// angles, of their squares divided by the variance that mixing::MixingAccuracy states.
struct MixingOutcome {
  std::vector<double> roll_deg, pitch_deg;
  double nees = 0;
};

MixingOutcome mixing_run(const MixingVariant& variant, const MixingExperiment& experiment,
                         const std::vector<MixingReading>& readings);

}  // namespace drydock::study
