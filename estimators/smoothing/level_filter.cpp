#include "estimators/smoothing/level_filter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "estimators/frame/earth.hpp"
#include "estimators/smoothing/singer.hpp"

namespace drydock::smoothing {

using Eigen::Matrix3d;
using Eigen::RowVector3d;
using Eigen::Vector3d;

namespace {

/// One sigma of a heading of which nothing is known: uniform around the circle, pi / sqrt(3).
constexpr double any_heading_rad = 1.8138;
constexpr double any_turn_radps = 0.1;  ///< as at the start of a dive
/// A gap between two headings is so many times as long as that before it.
constexpr double longest_usual = 4;
/// The largest sigma of a heading whose way is still about linear in its error.
constexpr double most_linear_rad = 0.5;
/// A heading behind a gap that is so many sigmas away shows that the motion does not tell the gap.
constexpr double most_explained = 3;
constexpr int most_refused = 3;  ///< headings, one after the other
/// A vehicle manoeuvres in bursts, and the likeliest motion is that of all its hours: the gate
/// takes what was expected as this much less certain, so that the begins of turns pass.
constexpr double burst_factor = 1.6;

double swing_of(const LevelMotion& motion) {
  return singer_acceleration(motion.turn_radps, motion.turn_change_s);
}

LevelVector start_sigma(const LevelSigmas& s, const LevelMotion& motion) {
  LevelVector sigma;
  sigma << s.position_m, s.position_m, s.depth_m, Vector3d::Constant(s.velocity_mps), s.heading_rad,
      s.turn_radps, s.heading_bias_rad, s.current_mps, s.current_mps,
      Vector3d::Constant(singer_acceleration(motion.velocity_mps, motion.acceleration_s)),
      swing_of(motion), s.bottom_scale, s.log_scale;
  return sigma;
}

/// Body axes as the device takes them -> the body's own.
Matrix3d misalignment(const SensorModel& sensor) {
  return frame::body_to_ned({0, sensor.pitch_rad, sensor.yaw_rad}).toRotationMatrix();
}

/// The same vector, swung by a quarter turn about the vertical: the derivative by the heading.
Vector3d swung(const Vector3d& v) { return {-v.y(), v.x(), 0}; }

}  // namespace

LevelFilter::LevelFilter(const LevelOptions& options) : options_(options), state_(options.start) {
  p_.diagonal() = start_sigma(options.sigmas, options.motion).cwiseAbs2();
}

const SensorModel& LevelFilter::sensor(std::uint16_t device) const {
  static const SensorModel perfect;
  return device < options_.sensors.size() ? options_.sensors[device] : perfect;
}

LevelMatrix LevelFilter::propagate(double dt, const HeadingAhead& ahead) {
  correction_.setZero();
  const LevelMatrix forgetting = forget_refused_heading();
  const LevelMatrix transition =
      loses_heading(dt, ahead)
          ? cross_gap(dt, ahead)
          : step(dt, options_.motion, middle_axes(state_, options_.motion, dt));
  unseen_s_ += dt;
  return transition * forgetting;
}

LevelMatrix LevelFilter::forget(int part, double sigma) {
  LevelMatrix forgetting = LevelMatrix::Identity();
  forgetting(part, part) = 0;
  p_ = forgetting * p_ * forgetting;
  p_(part, part) = sigma * sigma;
  return forgetting;
}

LevelMatrix LevelFilter::forget_refused_heading() {
  if (refused_headings_ < most_refused) return LevelMatrix::Identity();
  refused_headings_ = 0;
  return forget(heading_part, any_heading_rad) * forget(turn_part, any_turn_radps) *
         forget(turn_change_part, swing_of(options_.motion));
}

bool LevelFilter::loses_heading(double dt, const HeadingAhead& ahead) const {
  const double unseen_s = unseen_s_ + (ahead.reading != nullptr ? std::max(dt, ahead.in_s) : dt);
  if (unseen_s < any_heading_rad / any_turn_radps) return false;
  if (unseen_s > longest_usual * usual_s_) return true;
  const auto about = singer_step(options_.motion.turn_radps, options_.motion.turn_change_s, dt);
  if (about.noise(0, 0) + p_(heading_part, heading_part) > std::pow(most_linear_rad, 2))
    return true;
  if (ahead.reading == nullptr || ahead.in_s > dt) return false;
  LevelVector slope = LevelVector::Zero();
  slope(heading_part) = slope(bias_part) = 1;
  slope(turn_part) = about.transition(0, 1);
  slope(turn_change_part) = about.transition(0, 2);
  const double sigma = ahead.reading->sigma.x();
  const double variance = slope.dot(p_ * slope) + about.noise(0, 0) + sigma * sigma;
  const double expected = heading_row(sensor(ahead.reading->device)).expected +
                          slope(turn_part) * state_.turn_radps +
                          slope(turn_change_part) * state_.turn_change_radps2;
  const double residual = frame::wrap_pi(ahead.reading->value.x() - expected);
  return residual * residual > most_explained * most_explained * variance;
}

LevelMatrix LevelFilter::cross_gap(double dt, const HeadingAhead& ahead) {
  const LevelMatrix forgetting =
      forget(heading_part, 0) * forget(turn_part, 0) * forget(turn_change_part, 0);
  state_.turn_radps = state_.turn_change_radps2 = 0;
  Matrix3d axes = heading_to_ned(state_.heading_rad);
  double speed = state_.velocity.head<2>().norm();
  if (ahead.reading != nullptr) {
    const double part = (unseen_s_ + dt / 2) / (unseen_s_ + ahead.in_s);
    axes += part * (heading_to_ned(ahead.reading->value.x()) - axes);
    speed = std::max(speed, ahead.speed_mps);
    if (ahead.in_s <= dt) state_.heading_rad = ahead.reading->value.x();
  }
  LevelMotion straight = options_.motion;
  straight.turn_radps = 0;
  LevelMatrix transition = step(dt, straight, axes) * forgetting;
  const double any_way = speed * speed * dt * (2 * unseen_s_ + dt);
  p_.diagonal().segment<2>(position_part).array() += any_way;
  p_(heading_part, heading_part) = any_heading_rad * any_heading_rad;
  p_(turn_part, turn_part) = any_turn_radps * any_turn_radps;
  p_(turn_change_part, turn_change_part) = std::pow(swing_of(options_.motion), 2);
  return transition;
}

LevelMatrix LevelFilter::step(double dt, const LevelMotion& motion, const Matrix3d& axes) {
  const LevelMatrix q = wandering(motion, dt, axes);
  LevelMatrix transition = move(state_, motion, dt, axes);
  const LevelMatrix p = transition * p_ * transition.transpose() + q;
  p_ = (p + p.transpose()) / 2;
  return transition;
}

std::array<Residual, 3> LevelFilter::update(const Reading& reading, const Tilt& tilt) {
  const Rows rows = rows_of(reading, tilt);
  std::array<Residual, 3> residuals;
  LevelVector errors = LevelVector::Zero();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    if (rows[axis].slope.isZero(0) || std::isnan(reading.value(i))) continue;
    double residual = reading.quantity == Quantity::fix ? -rows[axis].expected
                                                        : reading.value(i) - rows[axis].expected;
    if (reading.quantity == Quantity::heading) residual = frame::wrap_pi(residual);
    residuals[axis] = take(rows[axis], residual, reading.sigma(i) * reading.sigma(i),
                           reading.quantity == Quantity::fix, errors);
  }
  state_.add(errors);
  correction_ += errors;
  if (reading.quantity == Quantity::heading && residuals[0].known) {
    refused_headings_ = residuals[0].used ? 0 : refused_headings_ + 1;
    if (residuals[0].used && unseen_s_ > 0) usual_s_ = std::exchange(unseen_s_, 0);
  }
  return residuals;
}

Residual LevelFilter::take(const Row& row, double residual, double variance, bool tells_scale,
                           LevelVector& errors) {
  const LevelVector cross = p_ * row.slope;
  const double of_state = row.slope.dot(cross), expected = of_state + variance;
  const double innovation = residual - row.slope.dot(errors);
  const double gate = options_.gate_sigma;
  Residual result{innovation, std::sqrt(expected), true, true};
  const double in_burst = burst_factor * burst_factor * of_state + variance;
  if (gate > 0 && innovation * innovation > gate * gate * in_burst) {
    result.used = false;
    return result;
  }
  const auto scales = p_.block<2, 2>(bottom_scale_part, bottom_scale_part).eval();
  LevelVector gain = cross / expected;
  if (!tells_scale) gain.segment<2>(bottom_scale_part).setZero();
  errors += innovation * gain;
  const LevelVector root = cross / result.sigma;
  p_.noalias() -= root * root.transpose();
  if (!tells_scale) p_.block<2, 2>(bottom_scale_part, bottom_scale_part) = scales;
  return result;
}

LevelFilter::Rows LevelFilter::rows_of(const Reading& reading, const Tilt& tilt) const {
  const SensorModel& model = sensor(reading.device);
  Rows rows;
  switch (reading.quantity) {
    case Quantity::bottom: return velocity_rows(model, tilt, false);
    case Quantity::log: rows = velocity_rows(model, tilt, true); break;
    case Quantity::fix: return fix_rows(reading, model, tilt);
    case Quantity::heading: rows[0] = heading_row(model); return rows;
    case Quantity::depth:
      rows[0].expected = (body_to_level(tilt) * model.lever).z() - state_.position.height_m;
      rows[0].slope(position_part + 2) = 1;
      return rows;
  }
  rows[2] = {};  // a log has no vertical axis
  return rows;
}

/// Eq. (S8) and (S9).
LevelFilter::Rows LevelFilter::velocity_rows(const SensorModel& sensor, const Tilt& tilt,
                                             bool of_water) const {
  const Matrix3d level = body_to_level(tilt);
  const double scale = 1 + sensor.scale_error + (of_water ? state_.log_scale : state_.bottom_scale);
  const Matrix3d to_sensor = scale * misalignment(sensor).transpose() * level.transpose();
  const Vector3d arm = swung(level * sensor.lever);
  Vector3d velocity =
      state_.velocity + state_.turn_radps * arm + moved_by_tilting(tilt, sensor.lever);
  const Matrix3d to_heading = heading_to_ned(state_.heading_rad).transpose();
  const Vector3d current = to_heading.leftCols<2>() * state_.current;
  if (of_water) velocity -= current;
  const Vector3d expected = to_sensor * velocity, by_turn = to_sensor * arm;
  const Vector3d by_heading = to_sensor * swung(current);
  const Eigen::Matrix<double, 3, 2> by_current = -to_sensor * to_heading.leftCols<2>();
  Rows rows;
  for (int i = 0; i < 3; ++i) {
    Row& row = rows[static_cast<std::size_t>(i)];
    row.expected = expected(i);
    row.slope.segment<3>(velocity_part) = to_sensor.row(i);
    row.slope(turn_part) = by_turn(i);
    row.slope(of_water ? log_scale_part : bottom_scale_part) = expected(i) / scale;
    if (!of_water) continue;
    row.slope(heading_part) = by_heading(i);
    row.slope.segment<2>(current_part) = by_current.row(i);
  }
  return rows;
}

/// Eq. (S10): where the antenna is expected, relative to the fix, m north, east and down.
LevelFilter::Rows LevelFilter::fix_rows(const Reading& reading, const SensorModel& sensor,
                                        const Tilt& tilt) const {
  const frame::Position& at = state_.position;
  const double meridian = frame::meridian_radius(at.latitude_rad) + at.height_m;
  const double transverse = frame::transverse_radius(at.latitude_rad) + at.height_m;
  const Vector3d arm = heading_to_ned(state_.heading_rad) * body_to_level(tilt) * sensor.lever;
  Rows rows;
  rows[0].expected = (at.latitude_rad - reading.value.x()) * meridian + arm.x();
  rows[1].expected = frame::wrap_pi(at.longitude_rad - reading.value.y()) * transverse *
                         std::cos(at.latitude_rad) +
                     arm.y();
  const Vector3d by_heading = swung(arm);
  for (int i = 0; i < 2; ++i) {
    rows[static_cast<std::size_t>(i)].slope(position_part + i) = 1;
    rows[static_cast<std::size_t>(i)].slope(heading_part) = by_heading(i);
  }
  if (options_.fix_heights) {
    rows[2].expected = reading.value.z() - at.height_m + arm.z();
    rows[2].slope(position_part + 2) = 1;
  }
  return rows;
}

/// Eq. (S11).
LevelFilter::Row LevelFilter::heading_row(const SensorModel& sensor) const {
  const auto [a, b, c] = sensor.deviation_rad;
  const double sine = std::sin(state_.heading_rad), cosine = std::cos(state_.heading_rad);
  Row row;
  row.expected = state_.heading_rad + state_.heading_bias_rad + a + b * sine + c * cosine;
  row.slope(heading_part) = 1 + b * cosine - c * sine;
  row.slope(bias_part) = 1;
  return row;
}

}  // namespace drydock::smoothing
