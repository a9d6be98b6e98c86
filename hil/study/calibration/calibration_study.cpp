#include "hil/study/calibration/calibration_study.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "drivers/measurement/units.hpp"
#include "estimators/calibration/calibrate.hpp"
#include "estimators/smoothing/level_smoother.hpp"
#include "hil/study/calibration/calibration_dive.hpp"

namespace drydock::study {
namespace {

using smoothing::LevelMotion;

/// Squares of one run between the fixes.
struct CalibrationTrack {
  double nees = 0, filter_m2 = 0, smoother_m2 = 0;
  int points = 0;
};

struct CalibrationOutcome {
  std::vector<double> error;  ///< found minus true, by parameter
  std::vector<calibration::Finding> findings;
  bool converged = false;
  CalibrationTrack track;
};

/// Over all runs, one parameter.
struct CalibrationSum {
  int told = 0, inside = 0;
  double squares = 0, sigmas = 0;

  void add(const calibration::Finding& finding, double error) {
    if (finding.verdict != calibration::Verdict::told) return;
    ++told;
    inside += std::abs(error) <= finding.bound() ? 1 : 0;
    squares += error * error;
    sigmas += finding.sigma;
  }
};

/// The vehicle's wandering is the same in all dives: it is fitted once, without errors.
LevelMotion fitted_motion(std::uint64_t seed) {
  const auto dive = calibration_dive({}, seed, 1'000'000);
  return smoothing::fit_noise(dive, calibration_options(dive), {}).motion;
}

CalibrationTrack calibration_track(std::uint64_t seed, std::size_t run, const LevelMotion& motion) {
  constexpr std::size_t every = 15;  // half a minute
  const auto dive = calibration_dive(drawn_bias(seed, run), seed, run);
  auto options = calibration_options(dive);
  options.motion = motion;
  const auto track = smoothing::smooth_level(dive, options);
  const auto& trajectory = calibration_trajectory();
  CalibrationTrack sum;
  for (std::size_t k = 0; k < track.smoothed.size(); k += every) {
    const auto& point = track.smoothed[k];
    const auto truth = trajectory.at(trajectory.start() + measurement::from_seconds(point.time_s));
    if (-truth.height_m < 0.5) continue;
    const frame::Position place{truth.latitude_rad, truth.longitude_rad, truth.height_m};
    const Eigen::Vector2d error = frame::ned_offset(place, point.position).head<2>();
    const Eigen::Matrix2d p = point.position_covariance.topLeftCorner<2, 2>();
    sum.nees += error.dot(p.inverse() * error) / 2;
    sum.smoother_m2 += error.squaredNorm();
    sum.filter_m2 += frame::ned_offset(place, track.filtered[k].position).head<2>().squaredNorm();
    ++sum.points;
  }
  return sum;
}

CalibrationOutcome calibration_run(std::uint64_t seed, std::size_t run, const LevelMotion& motion) {
  const auto errors = drawn_errors(seed, run);
  auto dive = calibration_dive(errors, seed, run);
  auto options = calibration_options(dive);
  options.motion = motion;
  const auto found = calibration::calibrate(dive, options, errors.parameters, {}, false);
  CalibrationOutcome outcome{{}, found.findings, found.converged, {}};
  for (std::size_t i = 0; i < errors.values.size(); ++i)
    outcome.error.push_back(found.findings[i].value - errors.values[i]);
  outcome.track = calibration_track(seed, run, motion);
  return outcome;
}

/// Angles are shown in degrees.
double calibration_factor(calibration::Unknown unknown) {
  return calibration::unit_of(unknown) == "rad" ? units::degrees_per_radian : 1;
}

std::string calibration_name(const calibration::Parameter& parameter) {
  constexpr std::array of{"DVL", "compass", "depth sensor", "receiver"};
  return fmt::format("{}: {}", of.at(parameter.device), name_of(parameter.unknown));
}

std::string calibration_unit(calibration::Unknown unknown) {
  const auto unit = calibration::unit_of(unknown);
  return unit == "rad" ? "deg" : std::string(unit);
}

}  // namespace

Result calibration_study(const Options& options, Progress& progress) {
  const auto motion = fitted_motion(options.seed);
  const auto parameters = drawn_errors(options.seed, 0).parameters;
  std::vector<CalibrationSum> sums(parameters.size());
  CalibrationTrack tracks;
  int converged = 0;
  Result result;
  result.runs = campaign(
      "calibration", options, progress,
      [&](std::size_t run) { return calibration_run(options.seed, run, motion); },
      [&](std::size_t, const CalibrationOutcome& outcome) {
        for (std::size_t i = 0; i < sums.size(); ++i)
          sums[i].add(outcome.findings[i], outcome.error[i]);
        converged += outcome.converged ? 1 : 0;
        tracks.nees += outcome.track.nees;
        tracks.filter_m2 += outcome.track.filter_m2;
        tracks.smoother_m2 += outcome.track.smoother_m2;
        tracks.points += outcome.track.points;
      });
  if (result.runs == 0) return result;
  const double nees = tracks.nees / tracks.points;
  const double ratio = std::sqrt(tracks.smoother_m2 / tracks.filter_m2);
  report::Table table{
      "95 % bounds of a calibration that hold the true value",
      {"parameter", "told in runs", "inside", "error RMS", "mean sigma", "unit"},
      {},
      fmt::format("only runs in which the parameter is called told count; goal 90 to "
                  "99 %. The smoother on these dives:\nNEES {:.3f}, RMSE {:.3f} of "
                  "the filter's between fixes.",
                  nees, ratio)};
  result.json = {{"converged", converged}, {"smoother_nees", nees}, {"smoother_rms_ratio", ratio}};
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const auto& sum = sums[i];
    const auto unknown = parameters[i].unknown;
    const double count = std::max(1, sum.told), factor = calibration_factor(unknown);
    const double rms = factor * std::sqrt(sum.squares / count), sigma = factor * sum.sigmas / count;
    table.rows.push_back({calibration_name(parameters[i]), fmt::format("{}", sum.told),
                          fmt::format("{:.1f} %", 100 * sum.inside / count),
                          fmt::format("{:.4f}", rms), fmt::format("{:.4f}", sigma),
                          calibration_unit(unknown)});
    result.json["parameters"].push_back({{"name", calibration_name(parameters[i])},
                                         {"unit", calibration_unit(unknown)},
                                         {"told", sum.told},
                                         {"inside_share", sum.inside / count},
                                         {"error_rms", rms},
                                         {"sigma_mean", sigma}});
  }
  result.tables = {table};
  return result;
}

}  // namespace drydock::study
