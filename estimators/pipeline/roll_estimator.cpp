#include "estimators/pipeline/roll_estimator.hpp"

#include <cmath>

namespace drydock::pipeline {

using measurement::GnssFix;
using measurement::GnssSatellites;
using measurement::ImuSample;
using measurement::seconds;
using measurement::Stamp;

namespace {

/// After this many samples in a row from the past, the clock was set back. Fewer are late samples.
constexpr int imu_set_back_after = 10;

/// The ground may hide satellites below this elevation. That such a satellite is not received says
/// nothing about the roll.
constexpr double surely_in_sight_rad = 0.1;

/// The least time between two heights that give a vertical speed, and the resulting sigma of the
/// pitch: the speed is late by half of the span plus the time until the next one, and the heights
/// have noise.
constexpr std::chrono::milliseconds climb_span{500};
constexpr double climb_sigma_rad = 0.015;

/// A rocket spins up, which no vehicle under water does: 0 to 3 turns a second in one second. A
/// faster leap of the roll gyro has to last for eight samples before it is believed.
constexpr double spin_up_radps2 = 20;

/// Signals that contradict so often, each time so soon behind the time before, say that the roll is
/// wrong by more than a filter finds back from.
constexpr int contradictions_of_a_wrong_roll = 3;
constexpr std::chrono::seconds soon{5};

/// Without an epoch of satellites for this long the roll is only that of the gyro.
constexpr std::chrono::seconds longest_without_epoch{10};

std::uint32_t mask_of(std::uint16_t device) { return std::uint32_t{1} << device; }

/// The options of the filter, with the weakest power that the receiver still reports.
roll::AllSatellitesOptions filter_options(const RollOptions& options) {
  roll::AllSatellitesOptions filter = options.filter;
  const double weakest_db =
      options.lowest_cno_dbhz - filter.antenna.resolution_db / 2 - options.boresight_cno_dbhz;
  filter.antenna.tracking_limit = std::pow(10, weakest_db / 10);
  return filter;
}

}  // namespace

std::string fault_of(const RollOptions& options) {
  if (!options.gnss) return "roll needs a satellite receiver, allowed: gnss = a device";
  return fault_of_devices({options.gnss});
}

std::unique_ptr<Estimator> make_estimator(Seat seat, const RollOptions& options,
                                          const PipelineOptions& pipeline) {
  return std::make_unique<RollEstimator>(seat, options, pipeline);
}

RollEstimator::RollEstimator(Seat seat, const RollOptions& options, const PipelineOptions& pipeline)
    : index_(seat.index),
      imu_(seat.imu),
      gnss_(options.gnss.value()),
      options_(options),
      max_imu_gap_(pipeline.max_imu_gap),
      max_fix_age_(pipeline.max_speed_age),
      alert_(pipeline.alert),
      filter_(filter_options(options)),
      gate_(spin_up_radps2) {}

Outcome RollEstimator::take(const ImuSample& sample, EstimateListener& listener) {
  if (sample.origin.device != imu_) return Outcome::unused;
  const double rate = sample.angular_rate.x();
  // This comparison is false for NaN too.
  if (!(std::abs(rate) <= max_angular_rate_radps)) return Outcome::refused;
  const Stamp at = sample.origin.valid_at;
  if (!gyro_.empty() && at <= last_) {
    if (!clock_was_set_back(sample)) return Outcome::late;
    stop();
  } else if (!gyro_.empty() && at - last_ > max_imu_gap_) {
    stop();
  }
  far_behind_ = 0;
  if (!gate_.believes(at, rate)) {
    ++status_.wild;
    return Outcome::refused;
  }
  if (const double leap = leap_.add(rate, gate_.noise()); leap != 0) filter_.loosen_bias(leap);
  if (imu_doubted_ || gnss_doubted_) trust_.judge(true, at);
  if (!gyro_.empty()) {
    const double dt = seconds(at - last_);
    filter_.predict(0.5 * (gyro_.rate() + rate), dt);
  } else {
    status_.state = EstimatorState::waiting_for_satellites;
  }
  gyro_.add(at, rate);
  last_ = at;
  if (filter_.running() && knows_axis(at)) emit(listener);
  return Outcome::accepted;
}

Outcome RollEstimator::take(const GnssFix& fix, EstimateListener&) {
  if (fix.origin.device != gnss_) return Outcome::unused;
  const auto velocity = velocity_of(fix);
  if (!velocity) return Outcome::unused;
  const double speed = velocity->norm();
  if (!(speed <= max_speed_mps)) return Outcome::refused;
  if (axis_ && fix.origin.valid_at < axis_->valid_at &&
      axis_->valid_at - fix.origin.valid_at < max_fix_age_)
    return Outcome::late;
  if (speed < options_.least_speed_mps) {
    axis_.reset();
    return Outcome::unused;
  }
  timing_.add(fix, *velocity);
  const double by_receiver =
      fix.velocity_ned ? fix.speed_accuracy_mps.value_or(0) / speed : climb_sigma_rad;
  const double sigma = std::hypot(options_.axis_sigma_rad, by_receiver);
  axis_ = Axis{fix.origin.valid_at, roll::flight_path(*velocity), sigma};
  return Outcome::accepted;
}

std::optional<Eigen::Vector3d> RollEstimator::velocity_of(const GnssFix& fix) {
  if (fix.velocity_ned) return fix.velocity_ned;
  const auto height = fix.mean_sea_level_height_m;
  if (!fix.ground_speed_mps || !fix.course_rad || !height) return std::nullopt;
  const Stamp at = fix.origin.valid_at;
  const auto since = height_ ? at - height_->valid_at : std::chrono::nanoseconds::zero();
  if (since <= since.zero() || since > 3 * climb_span) {
    height_ = Height{at, *height, std::nullopt};
  } else if (since >= climb_span) {
    height_ = Height{at, *height, (height_->metres - *height) / seconds(since)};
  }
  if (!height_->down_mps) return std::nullopt;
  return Eigen::Vector3d{*fix.ground_speed_mps * std::cos(*fix.course_rad),
                         *fix.ground_speed_mps * std::sin(*fix.course_rad), *height_->down_mps};
}

bool RollEstimator::knows_axis(Stamp at) const {
  return axis_ && std::chrono::abs(at - axis_->valid_at) <= max_fix_age_;
}

Outcome RollEstimator::take(const GnssSatellites& sky, EstimateListener&) {
  if (sky.origin.device != gnss_) return Outcome::unused;
  const Stamp at = sky.origin.valid_at;
  if (gyro_.empty() || at - last_ > max_imu_gap_ || !knows_axis(at)) return Outcome::unused;
  if (at < gyro_.oldest()) return Outcome::late;

  std::array<roll::Signal, roll::most_satellites> signals;
  std::size_t n = 0, heard = 0;
  for (const auto& satellite : sky.satellites) {
    if (!satellite.elevation_rad || !satellite.azimuth_rad || n == signals.size()) continue;
    if (!satellite.cno_dbhz && *satellite.elevation_rad < surely_in_sight_rad) continue;
    auto& signal = signals[n++];
    signal.satellite = static_cast<std::uint16_t>(256 * static_cast<int>(satellite.constellation) +
                                                  satellite.number);
    signal.toward_ned = roll::toward_ned(*satellite.elevation_rad, *satellite.azimuth_rad);
    signal.power.reset();
    if (!satellite.cno_dbhz) continue;
    signal.power = std::pow(10, (*satellite.cno_dbhz - options_.boresight_cno_dbhz) / 10);
    ++heard;
  }
  if (heard == 0) return Outcome::unused;  // the antenna has no signal at all, so this is no epoch

  filter_.update({.signals = std::span(signals).first(n),
                  .path = axis_->path,
                  .age_s = seconds(last_ - at),
                  .turned_rad = gyro_.now() - gyro_.at(at)});
  status_.state = EstimatorState::running;
  epoch_ = at;
  status_.rejected = filter_.rejected();
  judge();
  fed_by_ = mask_of(imu_) | mask_of(gnss_);
  return at < last_ ? Outcome::delayed : Outcome::accepted;
}

/// Eq. (37) of docs/estimators/roll.md. The filter first looks for the roll where it is, then
/// everywhere.
void RollEstimator::judge() {
  if (!filter_.watch().contradicts()) return;
  trust_.judge(true, last_);
  contradictions_ = contradicted_ && last_ - *contradicted_ <= soon ? contradictions_ + 1 : 1;
  contradicted_ = last_;
  if (contradictions_ < contradictions_of_a_wrong_roll) return filter_.loosen();
  ++status_.divergences;
  contradictions_ = 0;
  filter_.restart();
}

bool RollEstimator::clock_was_set_back(const ImuSample& sample) {
  const bool far = last_ - sample.origin.valid_at > max_imu_gap_;
  far_behind_ = far ? far_behind_ + 1 : 0;
  return far_behind_ >= imu_set_back_after;
}

void RollEstimator::stop() {
  if (filter_.running()) ++status_.restarts;
  status_.state = EstimatorState::waiting_for_imu;
  filter_.restart();
  gate_.forget();
  leap_.forget();
  gyro_.clear();
  axis_.reset();
  timing_.clear();
  height_.reset();
}

// `known_variance`: of the roll, without what the signals only suspect.
Integrity RollEstimator::integrity_of(const AttitudeEstimate& estimate,
                                      double known_variance) const {
  Integrity integrity;
  integrity.roll_bound_rad = bound_of(estimate.covariance(0, 0));
  integrity.pitch_bound_rad = bound_of(estimate.covariance(1, 1));
  integrity.heading_bound_rad = integrity.pitch_bound_rad;
  // The comparison of the roll is false for NaN too.
  integrity.valid = bound_of(known_variance) <= alert_.attitude_rad &&
                    last_ - epoch_ <= longest_without_epoch && trust_.settled(last_);
  return integrity;
}

void RollEstimator::emit(EstimateListener& listener) {
  ++status_.estimates;
  status_.last_estimate = last_;
  AttitudeEstimate estimate;
  estimate.valid_at = last_;
  estimate.estimator = index_;
  estimate.roll_rad = filter_.roll();
  estimate.pitch_rad = axis_->path.pitch_rad;
  estimate.yaw_rad = axis_->path.azimuth_rad;
  // An angle d between the axis and the velocity changes the roll angle by d sin(pitch).
  const double by_axis = axis_->sigma_rad * std::sin(estimate.pitch_rad);
  // A receiver that is late has signals of an earlier roll.
  const double by_time = gyro_.rate() * gyro_.rate() * timing_.variance();
  const double known = filter_.roll_variance() + by_axis * by_axis + by_time;
  estimate.covariance(0, 0) = known + filter_.watch().suspected_variance();
  estimate.covariance(1, 1) = axis_->sigma_rad * axis_->sigma_rad;
  estimate.fed_by = fed_by_;
  estimate.integrity = integrity_of(estimate, known);
  status_.valid = estimate.integrity.valid;
  status_.valid_estimates += status_.valid ? 1 : 0;
  listener.on_attitude(estimate);
}

}  // namespace drydock::pipeline
