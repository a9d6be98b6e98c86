#include <algorithm>
#include <cmath>

#include "drivers/measurement/axis_sigma.hpp"
#include "drivers/measurement/head_tilt.hpp"
#include "estimators/frame/mounted.hpp"
#include "estimators/pipeline/reckoning/dead_reckoning_estimator.hpp"

/// What dead reckoning takes beside the speeds: attitude, depth, fixes.
namespace drydock::pipeline {

using Eigen::Vector2d;
using measurement::seconds;

namespace {

/// The rate of turn is that of about this time: a compass is too coarse for the time between two
/// samples.
constexpr double turn_smoothing_s = 1;

void take_angle(const std::optional<double>& told, double& angle) {
  if (told && std::isfinite(*told)) angle = *told;
}

}  // namespace

/// The DVL's own compass and tilt sensors count only where no other ones tell the same. They are
/// those of its head. Where it tells no tilts, the vehicle is as level as it was told last.
void DeadReckoningEstimator::note_attitude(const measurement::BottomVelocity& track) {
  const auto& mounting = options_.dvl->sensor_to_body;
  if (const auto head = measurement::head_tilt(track); head && !tilt_told_) {
    const auto body = frame::of_body({head->roll_rad, head->pitch_rad, 0}, mounting);
    attitude_.roll = body.roll;
    attitude_.pitch = body.pitch;
  }
  if (options_.heading || !track.heading_rad || !std::isfinite(*track.heading_rad)) return;
  const auto down = frame::down_in_body(attitude_.roll, attitude_.pitch);
  const double turn = frame::heading_beside_sensor(down, mounting);
  note_heading(frame::wrap_pi(*track.heading_rad + options_.variation_rad + turn),
               track.origin.valid_at);
}

Outcome DeadReckoningEstimator::take(const measurement::AttitudeSample& sample, EstimateListener&) {
  if (!is_of(options_.heading, sample.origin)) return Outcome::unused;
  take_angle(sample.roll_rad, attitude_.roll);
  take_angle(sample.pitch_rad, attitude_.pitch);
  tilt_told_ |= sample.roll_rad && sample.pitch_rad;
  const auto magnetic = sample.heading_rad;
  if (!sample.true_heading_rad && !magnetic) {
    return sample.roll_rad || sample.pitch_rad ? Outcome::accepted : Outcome::unused;
  }
  const double heading =
      sample.true_heading_rad ? *sample.true_heading_rad : *magnetic + options_.variation_rad;
  if (!std::isfinite(heading)) return Outcome::refused;
  if (!begun_at_) begun_at_ = sample.origin.valid_at;
  note_heading(frame::wrap_pi(heading), sample.origin.valid_at);
  note_fed_by(options_.heading);
  return Outcome::accepted;
}

void DeadReckoningEstimator::note_heading(double heading_rad, Stamp at) {
  const double dt = heading_at_ ? seconds(at - *heading_at_) : 0;
  if (dt > options_.gap_s || dt < 0) {
    turn_radps_ = 0;
  } else if (dt > 0) {
    const double rate = frame::wrap_pi(heading_rad - heading_rad_) / dt;
    turn_radps_ += std::min(1.0, dt / turn_smoothing_s) * (rate - turn_radps_);
  }
  heading_rad_ = attitude_.yaw = heading_rad;
  heading_at_ = at;
}

/// The vehicle turned on since the newest heading.
void DeadReckoningEstimator::turn_to(Stamp at) {
  attitude_.yaw = frame::wrap_pi(heading_rad_ + turn_radps_ * seconds(at - *heading_at_));
}

Outcome DeadReckoningEstimator::take(const measurement::DepthSample& sample, EstimateListener&) {
  if (!is_of(options_.depth, sample.origin) || !sample.depth_m) return Outcome::unused;
  if (!std::isfinite(*sample.depth_m)) return Outcome::refused;
  depth_m_ = *sample.depth_m;
  depth_at_ = sample.origin.valid_at;
  note_fed_by(options_.depth);
  return Outcome::accepted;
}

Outcome DeadReckoningEstimator::take(const measurement::GnssFix& fix, EstimateListener& listener) {
  if (!is_of(options_.gnss, fix.origin) || !fix.position) return Outcome::unused;
  const double sigma = measurement::axis_sigma_m(fix).value_or(options_.fix_sigma_m);
  const frame::Position antenna{fix.position->latitude_rad, fix.position->longitude_rad,
                                position_ ? position_->height_m : options_.sea_level_m};
  if (!(sigma > 0) || !std::isfinite(antenna.latitude_rad + antenna.longitude_rad))
    return Outcome::refused;
  note_fed_by(options_.gnss);
  if (!position_) {
    options_.errors.position_m = sigma;
    filter_ = ReckoningFilter(options_.errors);
    fixed_ = Start{antenna, fix.origin.valid_at};
    return Outcome::accepted;
  }
  const double age_s = last_ ? seconds(fix.origin.valid_at - last_->valid_at) : 0;
  if (age_s < -options_.gap_s) return Outcome::late;
  const frame::Position origin = frame::at_ned_offset(antenna, -arm(options_.gnss));
  Vector2d offset =
      frame::ned_offset(*position_, frame::at_ned_offset(origin, arm(place()))).head<2>();
  if (last_) offset -= age_s * filter_.over_ground(last_->ned.head<2>(), last_->over);
  // The vehicle may have changed its speed since the last one.
  const double wandered = options_.errors.wander * std::sqrt(std::pow(std::abs(age_s), 3) / 3);
  const auto rows = filter_.fix(offset, std::hypot(sigma, wandered));
  for (const auto& row : rows) status_.taken.add(row.normalised_square());
  const double height_m = position_->height_m;
  position_ = frame::at_ned_offset(*position_, {offset.x(), offset.y(), 0});
  position_->height_m = height_m;
  listener.on_innovation({fix.origin.valid_at, index_, fix.origin.device, rows});
  return Outcome::accepted;
}

}  // namespace drydock::pipeline
