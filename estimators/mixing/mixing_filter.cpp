#include "estimators/mixing/mixing_filter.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "estimators/frame/earth.hpp"

namespace drydock::mixing {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

// Euler angles fail at a pitch of 90 deg. The estimate stays below this limit.
constexpr double steepest = std::numbers::pi / 2 - 1e-3;

double arcsine(double x) { return std::asin(std::clamp(x, -1.0, 1.0)); }

}  // namespace

// A step begins with the attitude that the step before ends with, so delays add up. A processor is
// late where it loads two numbers as one word that were stored one by one. So these functions hand
// single numbers on, and are inlined.

/// The motion that the inputs of a step give at the estimated attitude.
struct MixingFilter::Motion {
  Vector3d force;
  Vector3d rate;        ///< p, q, r against NED, eq. (1)
  Vector3d earth_rate;  ///< in body axes
  Vector3d down;        ///< C_n^b [0 0 1]
  double per_cos_pitch;
  double roll_rate, pitch_rate, yaw_rate;  ///< eq. (2)
  double speed, dt;
};

MixingFilter::MixingFilter(const MixingOptions& options)
    : options_(options),
      gravity_(frame::gravity(options.latitude_rad)),
      per_gravity_(1 / gravity_),
      earth_rate_ned_(frame::earth_rate_ned(options.latitude_rad)),
      heading_(options.heading_rad),
      gains_(options.type == MixingType::fixed_gain ? options.fixed : gains_of_level(1)) {}

void MixingFilter::start(const Vector3d& force, const Vector3d& rate, double speed) {
  if (options_.accelerometer_start) {
    start_by_accelerometers(force, rate, speed);
    settling_left_s_ = options_.settling_s;
    return;
  }
  roll_.set(options_.initial_roll_rad);
  pitch_.set(options_.initial_pitch_rad);
  settling_left_s_ = 0;
  forget(rate, speed);
}

// Eq. (5). A vehicle on its way may accelerate, and in the settling only the compensated type does
// not take that for a tilt.
void MixingFilter::start_by_accelerometers(const Vector3d& force, const Vector3d& rate,
                                           double speed) {
  settling_left_s_ = options_.type == MixingType::compensated ? options_.settling_s : 0;
  pitch_.set(std::clamp(arcsine(force.x() / gravity_), -steepest, steepest));
  roll_.set(arcsine((rate.z() * speed - force.y()) / (gravity_ * pitch_.cosine())));
  forget(rate, speed);
}

void MixingFilter::forget(const Vector3d& rate, double speed) {
  integral_.setZero();
  slow_rate_.setZero();
  slow_force_.setZero();
  drift_.setZero();
  slow_speed_ = speed;
  slow_turn_ = rate.tail<2>();
  slow_residual_ = unexplained_x_ = 0;
  level_ = 1;
}

MixingFilter::Motion MixingFilter::observe(const Vector3d& force, const Vector3d& rate,
                                           double speed, double dt) const {
  const double sin_roll = roll_.sine(), cos_roll = roll_.cosine();
  const double sin_pitch = pitch_.sine(), cos_pitch = pitch_.cosine();
  const double sin_yaw = heading_.sine(), cos_yaw = heading_.cosine();
  Motion m;
  m.force = force;
  m.down = {-sin_pitch, sin_roll * cos_pitch, cos_roll * cos_pitch};
  const Vector3d north{cos_pitch * cos_yaw, sin_roll * sin_pitch * cos_yaw - cos_roll * sin_yaw,
                       cos_roll * sin_pitch * cos_yaw + sin_roll * sin_yaw};
  const auto turning = [&](int axis) {
    return earth_rate_ned_.x() * north(axis) + earth_rate_ned_.z() * m.down(axis);
  };
  m.earth_rate = {turning(0), turning(1), turning(2)};
  m.rate = {rate.x() - m.earth_rate.x(), rate.y() - m.earth_rate.y(), rate.z() - m.earth_rate.z()};
  m.per_cos_pitch = 1 / cos_pitch;
  m.yaw_rate = (m.rate.y() * sin_roll + m.rate.z() * cos_roll) * m.per_cos_pitch;
  m.roll_rate = m.rate.x() + m.yaw_rate * sin_pitch;
  m.pitch_rate = m.rate.y() * cos_roll - m.rate.z() * sin_roll;
  m.speed = speed;
  m.dt = dt;
  return m;
}

void MixingFilter::step(const Vector3d& force, const Vector3d& rate, double speed, double dt) {
  if (dt != dt_) discretise(dt);
  const Motion m = observe(force, rate, speed, dt);
  const bool compensated = options_.type == MixingType::compensated;
  const Vector2d error = compensated ? compensated_error(m) : accelerometer_error(m);
  if (options_.type != MixingType::fixed_gain) choose_gains(m);

  // Fig. 2. The integral holds each error with the gain at the time of that error.
  integral_ = integral_kept_ * integral_ + integral_gain() * dt * error;
  const Vector2d correction = gains_.k1 * error + integral_;
  roll_.add((m.roll_rate + correction.x()) * dt);
  pitch_.add((m.pitch_rate + correction.y()) * dt);
  if (std::abs(pitch()) > steepest) pitch_.set(std::copysign(steepest, pitch()));
  heading_.add(m.yaw_rate * dt);
}

double MixingFilter::integral_gain() const {
  return options_.integral_gain == IntegralGain::k1_k2 ? gains_.k1 * gains_.k2 : gains_.k2;
}

double MixingFilter::integral_leak() const {
  return options_.type == MixingType::compensated ? 1 / options_.integral_leak_s : 0;
}

void MixingFilter::discretise(double dt) {
  const auto share = [dt](double tau) { return tau > 0 ? -std::expm1(-dt / tau) : 1.0; };
  dt_ = dt;
  low_pass_ = share(options_.low_pass_s);
  drift_kept_ = 1 - share(options_.velocity_leak_s);
  integral_kept_ = std::exp(-dt * integral_leak());
}

// Eq. (5): only the speed ahead is known of the motion.
Vector2d MixingFilter::accelerometer_error(const Motion& m) const {
  const double across = m.rate.z() * m.speed - m.force.y();
  return {arcsine(across * (per_gravity_ * m.per_cos_pitch)) - roll(),
          arcsine(m.force.x() * per_gravity_) - pitch()};
}

// Eq. (10) to (12). All terms of the residual are of the same instant before the low-pass, so the
// attitude does not lag. The acceleration of the log is the derivative of its speed after the same
// low-pass.
Vector2d MixingFilter::compensated_error(const Motion& m) {
  slow_turn_ += low_pass_ * (m.rate.tail<2>() - slow_turn_);
  const double v = -options_.pivot_m * slow_turn_.y(), w = options_.pivot_m * slow_turn_.x();

  const double along = m.force.x() + m.rate.z() * v - m.rate.y() * w + gravity_ * m.down.x();
  slow_residual_ += low_pass_ * (along - slow_residual_);
  const double gained = low_pass_ * (m.speed - slow_speed_);
  slow_speed_ += gained;
  unexplained_x_ = slow_residual_ - gained / m.dt;

  const double across = m.rate.z() * m.speed - m.rate.x() * w - m.force.y();
  const double per_gravity = per_gravity_ * m.per_cos_pitch;
  return {arcsine(across * per_gravity) - roll(), unexplained_x_ * per_gravity};
}

void MixingFilter::choose_gains(const Motion& m) {
  // Eq. (8). The Earth's rate counts twice: once for the rotation of the frame against inertial
  // space, once for the Coriolis acceleration.
  const Vector3d velocity{m.speed, drift_.x(), drift_.y()};
  const auto turning = [&](int axis) { return m.rate(axis) + 2 * m.earth_rate(axis); };
  const Vector3d coriolis = Vector3d{turning(0), turning(1), turning(2)}.cross(velocity);
  const auto change = [&](int axis) {
    return m.force(axis) + gravity_ * m.down(axis) - coriolis(axis);
  };
  const double along = change(0);
  const Vector2d across{change(1), change(2)};
  drift_ = drift_kept_ * (drift_ + across * m.dt);

  slow_rate_ += low_pass_ * (Vector2d{m.roll_rate, m.pitch_rate} - slow_rate_);
  slow_force_ += low_pass_ * (across - slow_force_);
  const double ahead = options_.type == MixingType::compensated ? unexplained_x_ : along;
  const double attitude_rate = slow_rate_.norm();                                     // eq. (6)
  const double velocity_rate = std::sqrt(ahead * ahead + slow_force_.squaredNorm());  // eq. (7)
  level_ = options_.type == MixingType::gain_schedule
               ? scheduled_level(attitude_rate, velocity_rate)
               : inferred_level(attitude_rate, velocity_rate, options_.sets);
  if (settling_left_s_ > 0) {
    settling_left_s_ -= m.dt;
    level_ = 1;
  }
  gains_ = gains_of_level(level_);
}

}  // namespace drydock::mixing
