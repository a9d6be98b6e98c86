#include "estimators/pipeline/reckoning/dead_reckoning_estimator.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::pipeline {

using Eigen::Vector3d;

namespace {

std::uint32_t mask(std::uint16_t device) { return std::uint32_t{1} << device; }

bool is_speed(const Vector3d& v) {
  return v.allFinite() && v.cwiseAbs().maxCoeff() <= DeadReckoningEstimator::max_speed_mps;
}

}  // namespace

std::string fault_of(const ReckoningOptions& options) {
  if (!options.dvl && !options.log)
    return "dead reckoning needs a speed, allowed: dvl or log = a device";
  if (!options.dvl && !options.heading)
    return "dead reckoning with a log alone needs a heading, allowed: heading = a device";
  if (!options.start && !options.gnss)
    return "dead reckoning needs a start, allowed: latitude_deg and longitude_deg, or gnss";
  for (const auto* device :
       {&options.dvl, &options.log, &options.heading, &options.depth, &options.gnss})
    if (*device)
      if (auto fault = fault_of_devices({(*device)->index}); !fault.empty()) return fault;
  return {};
}

std::unique_ptr<Estimator> make_estimator(Seat seat, const ReckoningOptions& options,
                                          const PipelineOptions& pipeline) {
  return std::make_unique<DeadReckoningEstimator>(seat, options, pipeline);
}

DeadReckoningEstimator::DeadReckoningEstimator(Seat seat, const ReckoningOptions& options,
                                               const PipelineOptions& pipeline)
    : index_(seat.index),
      options_(options),
      gap_(measurement::from_seconds(options.gap_s)),
      max_age_(pipeline.max_speed_age),
      alert_(pipeline.alert),
      filter_(options.errors),
      angles_(options) {
  status_.state = EstimatorState::waiting_for_speed;
  status_.longest_silence = gap_;
}

void DeadReckoningEstimator::doubt(std::uint16_t device, bool doubted) {
  if (options_.gnss && options_.gnss->index == device) gnss_doubted_ = doubted;
  if (options_.heading && options_.heading->index == device) heading_doubted_ = doubted;
}

Outcome DeadReckoningEstimator::take(const measurement::BottomVelocity& track,
                                     EstimateListener& listener) {
  if (!is_of(options_.dvl, track.origin)) return Outcome::unused;
  const Stamp at = track.origin.valid_at;
  if (!begun_at_) begun_at_ = at;
  note(angles_.take(track), at);
  if (!track.velocity || !angles_.knows_heading(at)) return Outcome::unused;
  if (!is_speed(*track.velocity) || is_wild(dvl_gate_, at, *track.velocity))
    return Outcome::refused;
  turn_to(at);
  const Speed speed{at, frame::body_to_ned(attitude_) * *track.velocity, attitude_.yaw,
                    SpeedOver::ground};
  const Outcome outcome = go_on(speed, listener);
  if (outcome == Outcome::accepted) {
    ground_at_ = at;
    last_ground_ = speed.ned;
    note_fed_by(options_.dvl);
  }
  return outcome;
}

Outcome DeadReckoningEstimator::take(const measurement::WaterSpeed& water,
                                     EstimateListener& listener) {
  if (!is_of(options_.log, water.origin) || !water.longitudinal_mps) return Outcome::unused;
  const Stamp at = water.origin.valid_at;
  if (!begun_at_) begun_at_ = at;
  // A log that tells no speed across: the origin has none, and the log swings around it.
  const double swing = angles_.turn_radps() * options_.log->lever.x();
  const Vector3d body{*water.longitudinal_mps, water.transverse_mps.value_or(swing), 0};
  if (!is_speed(body)) return Outcome::refused;
  if (!angles_.knows_heading(at)) return Outcome::unused;
  if (is_wild(log_gate_, at, body)) return Outcome::refused;
  turn_to(at);
  const Vector3d ned = frame::body_to_ned(attitude_) * body - rotation_at_log();
  const Speed speed{at, ned, attitude_.yaw, SpeedOver::water};
  if (!ground_at_ || !is_recent(*ground_at_, at)) {
    const Outcome outcome = go_on(speed, listener);
    if (outcome == Outcome::accepted) note_fed_by(options_.log);
    return outcome;
  }
  if (std::chrono::abs(at - *ground_at_) > max_age_) return Outcome::unused;
  compare(speed);
  note_fed_by(options_.log);
  return Outcome::accepted;
}

// A log that makes a step is like another current, which fixes or a DVL may show.
bool DeadReckoningEstimator::is_wild(SpeedGate& gate, Stamp at, const Vector3d& body) {
  const double doubted = gate.doubted_mps(at);
  const auto verdict = gate.judge(at, body);
  status_.wild += verdict == LeapGate::Verdict::wild ? 1 : 0;
  if (verdict == LeapGate::Verdict::stepped) {
    ++status_.steps;
    if (&gate == &log_gate_) filter_.loosen_current(std::max(doubted, gate.doubted_mps(at)));
  }
  return verdict == LeapGate::Verdict::wild;
}

// A current may change slowly, and then it is learned anew. A difference beyond the gate comes from
// the log or the DVL, nobody knows which: until both agree again the track may be as much off. When
// it lasts, the current is learned with it, and the doubt stays with the way that was made. Where
// the DVL is left out next, what was learned of the current may have been its error: the log
// carries it.
void DeadReckoningEstimator::compare(const Speed& water) {
  const auto rows = filter_.compare(last_ground_.head<2>(), water.ned.head<2>());
  speeds_.add(rows, water.valid_at);
  const double off = std::hypot(rows[0].value, rows[1].value);
  if (rows[0].used) {
    if (!speeds_.contradicts()) return;
    loosened_mps_ = off;
    loosened_at_ = water.valid_at;
    filter_.loosen_current(off);
    speeds_ = {};
    return;
  }
  speeds_off_mps_ = off;
  ++status_.rejected;
  if (!speeds_.lasts(water.valid_at)) return;
  ++status_.divergences;
  split_by(Eigen::Rotation2Dd(-water.heading_rad) * Eigen::Vector2d(rows[0].value, rows[1].value),
           water.valid_at);
  filter_.loosen_current(off);
  speeds_.begin_anew();
}

// `off`: in the vehicle's axes, because an error of log or DVL turns with it. What was taken for a
// current may go back, and then it was none.
void DeadReckoningEstimator::split_by(const Eigen::Vector2d& off, Stamp at) {
  split_mps_ += off;
  const bool back = split_mps_.norm() < off.norm() / 2;
  if (back) split_mps_.setZero();
  speeds_off_mps_ = split_mps_.norm();
  speeds_split_at_ = at;
}

bool DeadReckoningEstimator::is_recent(Stamp then, Stamp at) const {
  return std::chrono::abs(at - then) <= gap_;
}

void DeadReckoningEstimator::note_fed_by(const std::optional<ReckoningDevice>& device) {
  fed_by_ |= mask(device->index);
}

}  // namespace drydock::pipeline
