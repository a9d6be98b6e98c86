#include "hil/track/outcome.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "drivers/measurement/units.hpp"
#include "estimators/smoothing/level_smoother.hpp"
#include "hil/track/doubts.hpp"

namespace drydock::track {
namespace {

using smoothing::Quantity;
using smoothing::TrackPoint;

constexpr double longest_truth_gap_s = 1;

std::string passed_over_by(const Gathered& gathered) {
  std::string text;
  for (const auto& [reason, count] : gathered.passed_over)
    text += fmt::format("{}{} {}", text.empty() ? "; passed over: " : ", ", count, reason);
  return text;
}

/// Fixes without a heading and without a speed of the vehicle's own axes.
bool is_gnss_alone(const smoothing::Dive& dive) {
  return has(dive, Quantity::fix) && !has(dive, Quantity::heading) &&
         !has(dive, Quantity::bottom) && !has(dive, Quantity::log);
}

/// With a heading held north, the axes of the velocity are north and east: fixes need no more.
void hold_north(smoothing::LevelOptions& options) {
  options.start.heading_rad = 0;
  options.sigmas.heading_rad = options.sigmas.turn_radps = options.sigmas.heading_bias_rad = 0;
  options.motion.turn_radps = options.motion.heading_bias_rad = 0;
}

/// One sigma of an angle anywhere around the circle is pi / sqrt(3).
void tell_no_heading(Outcome& outcome) {
  for (auto* points : {&outcome.track.filtered, &outcome.track.smoothed})
    for (auto& point : *points) point.heading_sigma_rad = std::numbers::pi / std::numbers::sqrt3;
  outcome.notes.emplace_back(
      "GNSS alone: the track is that of the antenna, and its heading is not known");
}

/// Why there can be no track; empty: there can.
std::string obstacle(const Gathered& gathered) {
  const auto& dive = gathered.dive;
  if (dive.readings.empty()) return "nothing in it can make a track" + passed_over_by(gathered);
  if (dive.readings.front().time_s == dive.readings.back().time_s)
    return "all of its readings are of one moment";
  if (!has(dive, Quantity::heading) && !is_gnss_alone(dive))
    return "no heading: a compass, or a DVL with its own" + passed_over_by(gathered);
  if (!has(dive, Quantity::bottom) && !has(dive, Quantity::log) && !has(dive, Quantity::fix))
    return "no velocity: no bottom track, no log, no fix" + passed_over_by(gathered);
  return {};
}

/// Where nobody states the noise, the estimator of the rig does.
void state_noise(Gathered& gathered, const InertialSetup& setup) {
  for (auto& reading : gathered.dive.readings) {
    const smoothing::UnstatedNoise kind{reading.quantity, reading.device};
    const auto same = [&](const auto& one) {
      return one.quantity == kind.quantity && one.device == kind.device;
    };
    if (std::ranges::none_of(gathered.unstated, same)) continue;
    if (reading.quantity == Quantity::bottom) reading.sigma.setConstant(setup.bottom_sigma_mps);
    if (reading.quantity == Quantity::depth) reading.sigma.setConstant(setup.depth_sigma_m);
    if (reading.quantity == Quantity::heading) reading.sigma.setConstant(setup.heading_sigma_rad);
    if (reading.quantity == Quantity::fix) reading.sigma.setConstant(setup.fix_sigma_m);
  }
  gathered.unstated.clear();
}

void smooth_with_imu(Outcome& outcome, const InertialSetup& setup) {
  state_noise(outcome.gathered, setup);
  outcome.inertial = true;
  outcome.track = smoothing::smooth_inertial(outcome.gathered.dive, setup.options);
  outcome.notes.push_back("start and grade of the IMU are those of the estimator " +
                          setup.estimator);
}

/// Where a track without a fix begins.
frame::Position origin_of(Outcome& outcome, const std::optional<frame::Position>& origin) {
  if (has(outcome.gathered.dive, Quantity::fix)) return {};
  const auto& truth = outcome.gathered.truth;
  outcome.notes.emplace_back(origin          ? "no fix: the track begins where --start says"
                             : truth.empty() ? "no fix: the track begins at 0 N 0 E; see --start"
                                             : "no fix: the track begins at the recorded truth");
  if (origin) return *origin;
  return truth.empty() ? frame::Position{} : truth.front().position;
}

void smooth_without_imu(Outcome& outcome, const std::optional<frame::Position>& origin) {
  auto& gathered = outcome.gathered;
  if (const auto why = obstacle(gathered); !why.empty()) throw std::runtime_error(why);
  auto options = level_of(gathered, origin_of(outcome, origin));
  const bool gnss_alone = is_gnss_alone(gathered.dive);
  if (gnss_alone) hold_north(options);
  const auto fit = smoothing::fit_noise(gathered.dive, options, gathered.unstated);
  options.motion = fit.motion;
  for (std::size_t i = 0; i < gathered.unstated.size(); ++i)
    smoothing::scale_noise(gathered.dive, gathered.unstated[i], fit.factors[i]);
  outcome.track = smoothing::smooth_level(gathered.dive, options);
  if (gnss_alone) tell_no_heading(outcome);
  if (gathered.dive.tilts.empty())
    outcome.notes.emplace_back("nothing tells roll and pitch: the vehicle is taken as level");
}

SensorResiduals& place_of(std::vector<SensorResiduals>& all, const std::string& device,
                          Quantity quantity) {
  for (auto& one : all)
    if (one.device == device && one.quantity == quantity) return one;
  all.push_back({});
  all.back().device = device;
  all.back().quantity = quantity;
  return all.back();
}

/// Sums first; `mean`, `rms` and `nis` are divided at the end.
std::vector<SensorResiduals> residuals_of(const Gathered& gathered,
                                          const smoothing::Residuals& residuals) {
  std::vector<SensorResiduals> all;
  std::vector<double> axes;
  for (std::size_t i = 0; i < gathered.dive.readings.size(); ++i) {
    const auto& reading = gathered.dive.readings[i];
    auto& sum = place_of(all, gathered.device_name(reading.device), reading.quantity);
    axes.resize(all.size());
    auto& count = axes[static_cast<std::size_t>(&sum - all.data())];
    ++sum.readings;
    sum.sigma = reading.sigma.x();
    sum.fitted = std::ranges::any_of(gathered.unstated, [&](const auto& one) {
      return one.quantity == reading.quantity && one.device == reading.device;
    });
    bool known = false, refused = false;
    for (const auto& axis : residuals[i]) {
      if (!axis.known) continue;
      known = true;
      refused |= !axis.used;
      if (!axis.used) continue;
      if (&axis == &residuals[i][0]) sum.mean += axis.value;
      sum.rms += axis.value * axis.value;
      sum.nis += axis.normalised() * axis.normalised();
      ++count;
    }
    sum.unused += known ? 0 : 1;
    sum.refused += refused ? 1 : 0;
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].mean /= std::max(1.0, static_cast<double>(all[i].readings - all[i].unused));
    all[i].rms = std::sqrt(all[i].rms / std::max(1.0, axes[i]));
    all[i].nis /= std::max(1.0, axes[i]);
  }
  return all;
}

/// The truth at a time, on a line between its neighbours. Empty: they are too far away.
std::optional<frame::Position> truth_at(const std::vector<TruthPoint>& truth, double time_s) {
  const auto next = std::ranges::lower_bound(truth, time_s, {}, &TruthPoint::time_s);
  if (next == truth.end()) return {};
  if (next->time_s == time_s) return next->position;
  if (next == truth.begin()) return {};
  const auto& last = *std::prev(next);
  const double gap = next->time_s - last.time_s;
  if (gap > longest_truth_gap_s) return {};
  const auto whole = frame::ned_offset(last.position, next->position);
  return frame::at_ned_offset(last.position, whole * ((time_s - last.time_s) / gap));
}

Eigen::Vector2d miss(const frame::Position& truth, const TrackPoint& point) {
  return frame::ned_offset(truth, point.position).head<2>();
}

std::optional<TruthFigures> against_truth(const Outcome& outcome) {
  TruthFigures f;
  for (std::size_t k = 0; k < outcome.track.smoothed.size(); ++k) {
    const auto& point = outcome.track.smoothed[k];
    const auto truth = truth_at(outcome.gathered.truth, point.time_s);
    if (!truth) continue;
    const Eigen::Vector2d error = miss(*truth, point);
    const Eigen::Matrix2d p = point.position_covariance.topLeftCorner<2, 2>();
    ++f.points;
    f.filter_rms_m += miss(*truth, outcome.track.filtered[k]).squaredNorm();
    f.smoother_rms_m += error.squaredNorm();
    f.smoother_max_m = std::max(f.smoother_max_m, error.norm());
    f.smoother_end_m = error.norm();
    f.nees += error.dot(p.inverse() * error) / 2;
  }
  if (f.points == 0) return {};
  const auto points = static_cast<double>(f.points);
  f.filter_rms_m = std::sqrt(f.filter_rms_m / points);
  f.smoother_rms_m = std::sqrt(f.smoother_rms_m / points);
  f.nees /= points;
  return f;
}

void add_figures(Outcome& outcome) {
  const auto& points = outcome.track.smoothed;
  outcome.duration_s = points.back().time_s - points.front().time_s;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Eigen::Matrix2d p = points[k].position_covariance.topLeftCorner<2, 2>();
    const double largest = p.trace() / 2 + std::hypot((p(0, 0) - p(1, 1)) / 2, p(1, 0));
    outcome.worst_sigma_m = std::max(outcome.worst_sigma_m, std::sqrt(largest));
    if (k == 0) continue;
    const double dt = points[k].time_s - points[k - 1].time_s;
    outcome.distance_m += points[k].velocity_ned.head<2>().norm() * dt;
  }
  outcome.sensors = residuals_of(outcome.gathered, outcome.track.residuals);
  for (auto& doubt : doubts_of(outcome.gathered, outcome.track))
    outcome.notes.push_back(std::move(doubt));
  outcome.truth = against_truth(outcome);
}

}  // namespace

std::string_view name_of(Quantity quantity) {
  constexpr std::array<std::string_view, 5> names{"bottom track", "log", "depth", "heading", "fix"};
  return names.at(static_cast<std::size_t>(quantity));
}

std::string_view unit_of(Quantity quantity) {
  constexpr std::array<std::string_view, 5> units{"m/s", "m/s", "m", "rad", "m"};
  return units.at(static_cast<std::size_t>(quantity));
}

double shown(Quantity quantity, double value) {
  return quantity == Quantity::heading ? value * units::degrees_per_radian : value;
}

std::string_view shown_unit(Quantity quantity) {
  return quantity == Quantity::heading ? "deg" : unit_of(quantity);
}

Outcome smoothed(Gathered gathered, Model model, const std::optional<frame::Position>& origin) {
  Outcome outcome;
  outcome.notes = gathered.notes;
  const auto setup = inertial_of(gathered.rig);
  const bool can = setup && !gathered.dive.inertial.empty();
  if (model == Model::inertial && !can)
    throw std::runtime_error(
        "no inertial track: the rig needs an estimator of kind navigation or velocity, for start "
        "and grade of the IMU, and samples from the recording's begin on");
  outcome.gathered = std::move(gathered);
  outcome.has_heights = can || tells_height(outcome.gathered.dive);
  if (!outcome.has_heights)
    outcome.notes.emplace_back("nothing tells the height: the track has none");
  if (can && model != Model::level) {
    smooth_with_imu(outcome, *setup);
  } else {
    smooth_without_imu(outcome, origin);
  }
  if (outcome.track.smoothed.empty()) throw std::runtime_error("nothing in it can make a track");
  add_figures(outcome);
  return outcome;
}

}  // namespace drydock::track
