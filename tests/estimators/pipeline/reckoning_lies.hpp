#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "tests/estimators/pipeline/reckoning_runs.hpp"

/// A vehicle that goes north at 2 m/s, whose devices lie, and what its dead reckoning made of it.
namespace drydock::pipeline::reckoning_runs {

using Eigen::Vector2d;

inline constexpr double speed_mps = 2;

/// How long its estimates were valid and wrong in a row, and how many were not valid.
struct Judged {
  double wrong_s = 0;
  int invalid = 0;
};

/// The errors of north and east at 2 m/s to the north, beyond five sigmas.
inline Judged judged(const std::vector<NavigationEstimate>& all) {
  Judged judged;
  std::optional<Stamp> since;
  for (const auto& estimate : all) {
    const double north = speed_mps * measurement::seconds(estimate.valid_at - test::at_ms(0));
    const Vector3d error = frame::ned_offset(start, estimate.position) - Vector3d(north, 0, 0);
    const auto& p = estimate.covariance;
    const bool wrong = std::abs(error.x()) > 5 * std::sqrt(p(0, 0)) ||
                       std::abs(error.y()) > 5 * std::sqrt(p(1, 1));
    judged.invalid += estimate.integrity.valid ? 0 : 1;
    if (!wrong || !estimate.integrity.valid) {
      since.reset();
      continue;
    }
    if (!since) since = estimate.valid_at;
    judged.wrong_s = std::max(judged.wrong_s, measurement::seconds(estimate.valid_at - *since));
  }
  return judged;
}

inline ReckoningOptions by_log() {
  ReckoningOptions options;
  options.log = at_origin(log_device);
  options.heading = at_origin(compass_device);
  options.gnss = at_origin(gnss_device);
  return options;
}

inline ReckoningOptions by_both() {
  ReckoningOptions options = by_dvl();
  options.log = at_origin(log_device);
  options.heading = at_origin(compass_device);
  options.errors.position_m = 0.5;
  return options;
}

/// Noise that comes again: a few hundredths of its unit.
inline double wobble(int tick, int sensor) { return 0.02 * std::sin(2.3 * tick + 1.7 * sensor); }

/// What each device adds to the truth at a time, s; nothing: it is silent.
struct Lies {
  std::optional<Vector2d> fix = Vector2d{0, 0};
  std::optional<double> log = 0, dvl = 0, heading = 0;
};

/// 5 Hz of compass and DVL, 2.5 Hz of the log, 1 Hz of fixes.
template <class Liar>
void sail(Reckoning& run, double to_s, const Liar& lies_at, double from_s = 0) {
  for (int tick = static_cast<int>(5 * from_s); tick <= 5 * to_s; ++tick) {
    const double s = tick / 5.0;
    const Lies lies = lies_at(s);
    const int ms = 200 * tick;
    if (lies.heading) run.take(compass(ms, *lies.heading + wobble(tick, 1) * 0.1));
    if (lies.dvl) run.take(track(ms, {speed_mps + *lies.dvl + wobble(tick, 2), 0, 0}, 0));
    if (lies.log && tick % 2 == 0) run.take(log_speed(ms, speed_mps + *lies.log + wobble(tick, 3)));
    if (lies.fix && tick % 5 == 0)
      run.take(fix(ms, {speed_mps * s + lies.fix->x(), lies.fix->y(), 0}, 0.1));
  }
}

inline bool within(double s, double from, double to) { return s >= from && s < to; }

}  // namespace drydock::pipeline::reckoning_runs
