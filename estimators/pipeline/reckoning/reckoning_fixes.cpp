#include <algorithm>
#include <cmath>

#include "drivers/measurement/axis_sigma.hpp"
#include "estimators/pipeline/reckoning/dead_reckoning_estimator.hpp"

/// What fixes do to a dead reckoning: "Fixes" of docs/estimators/dead-reckoning.md.
namespace drydock::pipeline {

using Eigen::Vector2d;
using measurement::seconds;

Outcome DeadReckoningEstimator::take(const measurement::GnssFix& fix, EstimateListener& listener) {
  // A finding says that it is of another time: the vehicle has moved since.
  if (!is_of(options_.gnss, fix.origin) || !fix.position || gnss_doubted_) return Outcome::unused;
  const Start here{{fix.position->latitude_rad, fix.position->longitude_rad,
                    position_ ? position_->height_m : options_.sea_level_m},
                   fix.origin.valid_at,
                   measurement::axis_sigma_m(fix).value_or(options_.fix_sigma_m)};
  if (!(here.sigma_m > 0) || !std::isfinite(here.antenna.latitude_rad + here.antenna.longitude_rad))
    return Outcome::refused;
  if (!position_) {
    options_.errors.position_m = here.sigma_m;
    filter_ = ReckoningFilter(options_.errors);
    fixed_ = here;
    note_fed_by(options_.gnss);
    return Outcome::accepted;
  }
  const double age_s = last_ ? seconds(here.valid_at - last_->valid_at) : 0;
  if (age_s < -options_.gap_s) return Outcome::late;
  note_fed_by(options_.gnss);
  if (age_s > options_.gap_s)
    take_in_gap(here, age_s, listener);
  else
    use(here, age_s, listener);
  return Outcome::accepted;
}

/// From the track's place to that of the fix, north and east, m.
Vector2d DeadReckoningEstimator::offset_of(const Start& fix) const {
  const frame::Position origin = frame::at_ned_offset(fix.antenna, -arm(options_.gnss));
  return frame::ned_offset(*position_, frame::at_ned_offset(origin, arm(place()))).head<2>();
}

void DeadReckoningEstimator::use(const Start& fix, double age_s, EstimateListener& listener) {
  Vector2d offset = offset_of(fix);
  if (last_) offset -= age_s * filter_.over_ground(last_->ned.head<2>(), last_->over);
  // The vehicle may have changed its speed since the last one.
  const double sigma = std::hypot(fix.sigma_m, std::sqrt(filter_.wandered_behind(std::abs(age_s))));
  Vector2d step = offset;
  auto rows = filter_.fix(step, sigma);
  fixes_.add(rows, fix.valid_at);
  if (fixes_.lasts(fix.valid_at)) {
    believe_fixes(offset.norm(), fix.valid_at);
    if (!rows[0].used) rows = filter_.fix(step = offset, sigma);
  }
  const double height_m = position_->height_m;
  position_ = frame::at_ned_offset(*position_, {step.x(), step.y(), 0});
  position_->height_m = height_m;
  tell(rows, fix.valid_at, listener);
}

/// Fixes and track have contradicted each other for long, and nobody knows which is right. It goes
/// on at the fixes, which will be right sooner or later; for a while its bound reaches back to the
/// track that it leaves.
void DeadReckoningEstimator::believe_fixes(double off_m, Stamp at) {
  ++status_.divergences;
  filter_.loosen(off_m);
  separation_m2_ = separation_variance(at) + off_m * off_m;
  separated_at_ = at;
  fixes_.begin_anew();
}

double DeadReckoningEstimator::separation_variance(Stamp at) const {
  constexpr std::chrono::minutes forgotten_after{5};
  return separated_at_ && at - *separated_at_ <= forgotten_after ? separation_m2_ : 0;
}

/// Without speeds the vehicle may be anywhere where it can have got. The newest fix within that is
/// where the track begins again.
void DeadReckoningEstimator::take_in_gap(const Start& fix, double age_s,
                                         EstimateListener& listener) {
  const Vector2d velocity = filter_.over_ground(last_->ned.head<2>(), last_->over);
  const Vector2d offset = offset_of(fix) - age_s * velocity;
  const double turned = velocity.norm() * age_s * unseen_turn_rad(age_s);
  navigation::Innovations rows;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const double sigma = std::sqrt(filter_.covariance()(axis, axis) + fix.sigma_m * fix.sigma_m +
                                   turned * turned + filter_.wandered_behind(age_s));
    const bool used =
        std::abs(offset(axis)) <= navigation::InnovationWindow::outlier_sigmas * sigma;
    rows.push_back({offset(axis), sigma, used});
  }
  fixes_.add(rows, fix.valid_at);
  if (rows[0].used && rows[1].used) fixed_ = fix;
  tell(rows, fix.valid_at, listener);
}

void DeadReckoningEstimator::tell(const navigation::Innovations& rows, Stamp at,
                                  EstimateListener& listener) {
  for (const auto& row : rows) {
    if (row.used)
      status_.taken.add(row.normalised_square());
    else
      ++status_.rejected;
  }
  listener.on_innovation({at, index_, options_.gnss->index, rows});
}

}  // namespace drydock::pipeline
