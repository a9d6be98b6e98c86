#include "estimators/pipeline/reckoning/reckoning_attitude.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/measurement/head_tilt.hpp"
#include "estimators/frame/mounted.hpp"

namespace drydock::pipeline {

using measurement::seconds;

namespace {

/// The rate of turn is that of about this time: a compass is too coarse for the time between two
/// samples.
constexpr double turn_smoothing_s = 1;

/// One sigma of a vehicle's angular acceleration, rad/s2: an eighth of what the fins of a REMUS
/// make, docs/estimators/integrity.md.
constexpr double turn_change_radps2 = 0.05;

constexpr double least_leap_rad = 0.0175;
constexpr LeapLimits heading_limits{
    .change_per_s = 0.3, .change_per_s2 = 0.5, .least = least_leap_rad, .angle = true};
constexpr LeapLimits tilt_limits{.change_per_s = 0.3, .least = least_leap_rad, .angle = true};

/// A compass that has been silent for this long is stood in for.
constexpr double stand_in_after_s = 1;
/// The headings that tell how the DVL's compass lies beside the other, and how much it then errs:
/// a deviation that changes with the heading.
constexpr int beside_dvl_samples = 50;
constexpr double deviation_rad = 0.05;

/// How a vehicle rolls and pitches while its tilt is wild, rad/s. Chosen.
constexpr double unseen_tilt_radps = 0.0175;

double variance_of(double sigma) { return sigma * sigma; }

navigation::Innovation row(double value, double sigma) {
  return {value, sigma, std::abs(value) <= navigation::InnovationWindow::outlier_sigmas * sigma};
}

}  // namespace

ReckoningAttitude::ReckoningAttitude(const ReckoningOptions& options)
    : dvl_(options.dvl),
      has_compass_(options.heading.has_value()),
      variation_rad_(options.variation_rad),
      gap_s_(options.gap_s),
      tilt_variance_(variance_of(options.tilt_sigma_rad)),
      heading_sigma_rad_(options.errors.heading_rad),
      roll_(tilt_limits),
      pitch_(tilt_limits),
      heading_(heading_limits) {}

ReckoningAttitude::Taken ReckoningAttitude::take(const measurement::AttitudeSample& sample) {
  Taken taken;
  const Stamp at = sample.origin.valid_at;
  note_tilt(sample.roll_rad, at, roll_, roll_rad_, taken);
  note_tilt(sample.pitch_rad, at, pitch_, pitch_rad_, taken);
  if (sample.roll_rad && sample.pitch_rad && taken.wild == 0) tilt_at_ = at;
  if (!sample.true_heading_rad && !sample.heading_rad) return taken;
  const double heading =
      sample.true_heading_rad ? *sample.true_heading_rad : *sample.heading_rad + variation_rad_;
  note_heading(frame::wrap_pi(heading), at, taken);
  if (!taken.heading) return taken;
  compass_at_ = at;
  if (stands_in_) taken.stepped_rad = heading_.stepped();
  stands_in_ = false;
  return taken;
}

/// The DVL's own compass and tilt sensors count only where no other ones tell the same. They are
/// those of its head. Where it tells no tilts, the vehicle is as level as it was told last.
ReckoningAttitude::Taken ReckoningAttitude::take(const measurement::BottomVelocity& track) {
  Taken taken;
  const Stamp at = track.origin.valid_at;
  const auto& mounting = dvl_->sensor_to_body;
  if (const auto head = measurement::head_tilt(track)) {
    const auto body = frame::of_body({head->roll_rad, head->pitch_rad, 0}, mounting);
    if (is_recent(tilt_at_, at, gap_s_)) {
      compare_tilts(body, at);
    } else {
      note_tilt(body.roll, at, roll_, roll_rad_, taken);
      note_tilt(body.pitch, at, pitch_, pitch_rad_, taken);
    }
  }
  if (!track.heading_rad || !std::isfinite(*track.heading_rad)) return taken;
  const auto down = frame::down_in_body(roll_rad_, pitch_rad_);
  const double by_dvl = frame::wrap_pi(*track.heading_rad + variation_rad_ +
                                       frame::heading_beside_sensor(down, mounting));
  if (!has_compass_) {
    note_heading(by_dvl, at, taken);
  } else if (is_recent(compass_at_, at, stand_in_after_s)) {
    compare_headings(by_dvl, at);
  } else if (beside_dvl_known_ >= beside_dvl_samples) {
    note_heading(frame::wrap_pi(by_dvl + beside_dvl_rad_), at, taken);
    if (taken.heading) taken.stepped_rad = std::hypot(heading_.stepped(), deviation_rad);
    stands_in_ = true;
  }
  return taken;
}

void ReckoningAttitude::note_tilt(const std::optional<double>& told, Stamp at, LeapGate& gate,
                                  double& angle, Taken& taken) {
  if (!told || !std::isfinite(*told)) return;
  if (gate.judge(at, *told) == LeapGate::Verdict::wild) {
    ++taken.wild;
    return;
  }
  angle = *told;
  taken.tilt = true;
}

void ReckoningAttitude::note_heading(double heading_rad, Stamp at, Taken& taken) {
  if (!std::isfinite(heading_rad)) return;
  const auto verdict = heading_.judge(at, heading_rad, turn_radps_);
  if (verdict == LeapGate::Verdict::wild) {
    ++taken.wild;
    return;
  }
  const double dt = heading_at_ ? seconds(at - *heading_at_) : 0;
  if (verdict == LeapGate::Verdict::stepped) {
    taken.stepped_rad = heading_.stepped();
  } else if (dt > gap_s_ || dt < 0) {
    turn_radps_ = 0;
  } else if (dt > 0) {
    const double rate = frame::wrap_pi(heading_rad - heading_rad_) / dt;
    turn_radps_ += std::min(1.0, dt / turn_smoothing_s) * (rate - turn_radps_);
  }
  heading_rad_ = heading_rad;
  heading_at_ = at;
  taken.heading = true;
}

double ReckoningAttitude::tilt_variance(const LeapGate& gate, Stamp at) const {
  return tilt_variance_ + variance_of(gate.stepped()) +
         variance_of(unseen_tilt_radps * gate.unknown_s(at));
}

void ReckoningAttitude::compare_tilts(const frame::Euler& head, Stamp at) {
  const double sigma = std::sqrt(2 * tilt_variance_);
  tilts_.add({row(frame::wrap_pi(roll_rad_ - head.roll), sigma),
              row(frame::wrap_pi(pitch_rad_ - head.pitch), sigma)},
             at);
}

// Two compasses differ by a constant, which is learned, and by their deviations.
void ReckoningAttitude::compare_headings(double by_dvl, Stamp at) {
  const double beside = frame::wrap_pi(this->at(at).yaw - by_dvl);
  const double off = frame::wrap_pi(beside - beside_dvl_rad_);
  if (beside_dvl_known_ >= beside_dvl_samples) {
    const auto compared = row(off, std::hypot(heading_sigma_rad_, deviation_rad));
    headings_.add({compared}, at);
    if (!compared.used || headings_.contradicts()) return;
  }
  beside_dvl_known_ = std::min(beside_dvl_known_ + 1, 3 * beside_dvl_samples);
  beside_dvl_rad_ = frame::wrap_pi(beside_dvl_rad_ + off / beside_dvl_known_);
}

bool ReckoningAttitude::is_recent(const std::optional<Stamp>& then, Stamp at,
                                  double within_s) const {
  return then && std::abs(seconds(at - *then)) <= within_s;
}

bool ReckoningAttitude::knows_heading(Stamp at) const { return is_recent(heading_at_, at, gap_s_); }

frame::Euler ReckoningAttitude::at(Stamp at) const {
  const double turned = heading_at_ ? turn_radps_ * seconds(at - *heading_at_) : 0;
  return {roll_rad_, pitch_rad_, frame::wrap_pi(heading_rad_ + turned)};
}

double ReckoningAttitude::unknown_turn_rad(Stamp at) const {
  const double age_s = heading_at_ ? std::abs(seconds(at - *heading_at_)) : 0;
  return turn_change_radps2 * age_s * (turn_smoothing_s + age_s / 2);
}

}  // namespace drydock::pipeline
