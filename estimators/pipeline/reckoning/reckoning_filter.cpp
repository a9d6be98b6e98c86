#include "estimators/pipeline/reckoning/reckoning_filter.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/navigation/innovation_window.hpp"

namespace drydock::pipeline {

using Eigen::Matrix2d;
using Eigen::Vector2d;

namespace {

/// What was learned of heading and current is forgotten with this time constant: in the six hours
/// in which a tide turns, two fifths of the variance come back. Chosen.
constexpr double forgotten_after_s = 86'400;

double square(double x) { return x * x; }

/// Turned by 90 degrees to the right: how a velocity changes with its heading.
Vector2d across(const Vector2d& v) { return {-v.y(), v.x()}; }

}  // namespace

ReckoningFilter::ReckoningFilter(const ReckoningErrors& errors) : sigmas_(errors) {
  Vector6 sigmas;
  sigmas << errors.position_m, errors.position_m, errors.heading_rad, errors.scale,
      errors.current_mps, errors.current_mps;
  covariance_ = sigmas.cwiseAbs2().asDiagonal();
}

Vector2d ReckoningFilter::over_ground(const Vector2d& measured, SpeedOver over) const {
  const Eigen::Rotation2Dd turn(errors_(2));
  return over == SpeedOver::ground ? Vector2d((1 + errors_(3)) * (turn * measured))
                                   : Vector2d(turn * (measured + errors_.tail<2>()));
}

Vector2d ReckoningFilter::as_measured(const Vector2d& ground, SpeedOver over) const {
  const Vector2d turned = Eigen::Rotation2Dd(-errors_(2)) * ground;
  return over == SpeedOver::ground ? Vector2d(turned / (1 + errors_(3)))
                                   : Vector2d(turned - errors_.tail<2>());
}

Eigen::Matrix<double, 2, 6> ReckoningFilter::sensitivity(const Vector2d& measured,
                                                         SpeedOver over) const {
  const Vector2d v = over_ground(measured, over);
  Eigen::Matrix<double, 2, 6> by_error = Eigen::Matrix<double, 2, 6>::Zero();
  by_error.col(2) = across(v);
  if (over == SpeedOver::ground)
    by_error.col(3) = v / (1 + errors_(3));
  else
    by_error.rightCols<2>() = Eigen::Rotation2Dd(errors_(2)).matrix();
  return by_error;
}

Vector2d ReckoningFilter::current() const {
  return Eigen::Rotation2Dd(errors_(2)) * errors_.tail<2>();
}

Vector2d ReckoningFilter::current_sigma() const {
  const auto by_error = sensitivity(Vector2d::Zero(), SpeedOver::water);
  return (by_error * covariance_ * by_error.transpose()).diagonal().cwiseMax(0).cwiseSqrt();
}

double ReckoningFilter::noise_mps(SpeedOver over) const {
  return over == SpeedOver::ground ? sigmas_.velocity_mps : sigmas_.water_speed_mps;
}

// Between two known speeds the speed wanders as a Brownian bridge, whose integral has the variance
// q T^3 / 12; Brownian motion that ends or begins at a known speed has q T^3 / 3.
double ReckoningFilter::wandered_between(double dt) const {
  return square(sigmas_.wander) * std::pow(dt, 3) / 12;
}
double ReckoningFilter::wandered_behind(double dt) const { return 4 * wandered_between(dt); }

// Each speed counts for half of the intervals on both sides.
Vector2d ReckoningFilter::move(const Vector2d& mean, double dt, SpeedOver over,
                               const WayNoise& noise) {
  Matrix6 transition = Matrix6::Identity();
  transition.topRows<2>() += dt * sensitivity(mean, over);
  covariance_ = transition * covariance_ * transition.transpose();
  const double aside = square(noise.aside_mps) * dt * std::max(dt, noise.aside_s);
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    double& variance = covariance_(axis, axis);
    variance = square(std::sqrt(variance) + noise.wrong_mps * dt) + square(noise_mps(over) * dt) +
               noise.wandered_m2 + aside;
  }
  forget(dt);
  return dt * over_ground(mean, over);
}

// Heading and current are constants for a while only: what was learned of them goes back to what
// was known at the start. What nothing has shown does not change.
void ReckoningFilter::forget(double dt) {
  const double share = 1 - std::exp(-2 * dt / forgotten_after_s);
  const auto go_back = [&](Eigen::Index state, double sigma) {
    double& variance = covariance_(state, state);
    variance += share * std::max(0.0, square(sigma) - variance);
  };
  go_back(2, sigmas_.heading_rad);
  go_back(4, sigmas_.current_mps);
  go_back(5, sigmas_.current_mps);
}

Matrix2d ReckoningFilter::velocity_covariance(const Vector2d& measured, SpeedOver over) const {
  const auto by_error = sensitivity(measured, over);
  return by_error * covariance_ * by_error.transpose() +
         square(noise_mps(over)) * Matrix2d::Identity();
}

// The heading has no part in it: both speeds are turned by the same one, and so is the current.
navigation::Innovations ReckoningFilter::compare(const Vector2d& ground, const Vector2d& water) {
  const double variance = square(sigmas_.velocity_mps) + square(sigmas_.water_speed_mps);
  std::array<Compared, 2> rows;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    Row h = Row::Unit(4 + axis);
    h(3) = -ground(axis);
    rows[static_cast<std::size_t>(axis)] = {h, ground(axis) - water(axis), variance};
  }
  return update(rows);
}

navigation::Innovations ReckoningFilter::fix(Vector2d& offset, double sigma_m) {
  const double variance = square(sigma_m);
  auto rows = update({{{Row::Unit(0), offset(0), variance}, {Row::Unit(1), offset(1), variance}}});
  offset = errors_.head<2>();
  errors_.head<2>().setZero();
  return rows;
}

// One row behind the other, each against what the row before has shown; but first both are looked
// at, so that a row beyond the gate keeps the other one out.
navigation::Innovations ReckoningFilter::update(std::array<Compared, 2> rows) {
  navigation::Innovations told;
  bool inside = true;
  for (const auto& [h, value, variance] : rows) {
    const double innovation = value - (h * errors_).value();
    const double sigma = std::sqrt((h * covariance_ * h.transpose()).value() + variance);
    // This comparison is false for NaN too.
    inside &= std::abs(innovation) <= navigation::InnovationWindow::outlier_sigmas * sigma;
    told.push_back({innovation, sigma, false});
  }
  if (!inside) return told;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& [h, value, variance] = rows[i];
    const double innovation = value - (h * errors_).value();
    const double expected = (h * covariance_ * h.transpose()).value() + variance;
    told[i] = {innovation, std::sqrt(expected), true};
    update(h, innovation, variance);
  }
  return told;
}

void ReckoningFilter::update(const Row& h, double innovation, double variance) {
  const Vector6 cross = covariance_ * h.transpose();
  const Vector6 gain = cross / ((h * cross).value() + variance);
  errors_ += gain * innovation;
  covariance_ -= gain * cross.transpose();
  covariance_ = (covariance_ + covariance_.transpose().eval()) / 2;
}

void ReckoningFilter::begin_at_fix(double sigma_m) {
  covariance_.topRows<2>().setZero();
  covariance_.leftCols<2>().setZero();
  covariance_(0, 0) = covariance_(1, 1) = square(sigma_m);
}

void ReckoningFilter::loosen(double position_m) {
  covariance_.diagonal().head<2>().array() += square(position_m);
  covariance_(2, 2) += square(sigmas_.heading_rad);
  loosen_current(sigmas_.current_mps);
}

void ReckoningFilter::doubt_heading(double rad) {
  double& variance = covariance_(2, 2);
  const double doubted = square(sigmas_.heading_rad) + square(rad);
  if (rad != 0) {
    variance = std::max(variance, doubted);
    return;
  }
  covariance_.row(2).setZero();
  covariance_.col(2).setZero();
  variance = doubted + square(errors_(2));  // what was learned meanwhile may be of the fault
}

void ReckoningFilter::loosen_current(double mps) {
  covariance_.diagonal().tail<2>().array() += square(mps);
}

}  // namespace drydock::pipeline
