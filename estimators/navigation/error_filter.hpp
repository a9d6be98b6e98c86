#pragma once

#include <cmath>
#include <utility>

#include "estimators/lanes/real.hpp"
#include "estimators/navigation/error_model.hpp"

namespace drydock::navigation {

/// True if a normalised squared innovation is outside `gate_sigma`. 0: there is no gate.
inline bool outside_gate(double normalised_square, double gate_sigma) {
  return gate_sigma > 0 && normalised_square > gate_sigma * gate_sigma;
}

/// Kalman filter of the 15 errors of eq. (14) and of `Further` constant states. The owner defines
/// the meaning and the units of the further states. The owner feeds estimated errors back, so the
/// state is zero between updates and this class does not store it.
template <int Further, class Real = double>
class ErrorFilter {
 public:
  static constexpr int size = 15 + Further;
  /// An odd `size` gets one more state, always zero, so that each column fills whole SIMD words.
  static constexpr int stored = size + size % 2;
  using Vector = Eigen::Matrix<Real, stored, 1>;
  using Covariance = Eigen::Matrix<Real, stored, stored>;

  /// `sigma`: one standard deviation of each error.
  explicit ErrorFilter(const Vector& sigma) : p_(sigma.array().square().matrix().asDiagonal()) {}

  /// Eq. (15): P <- (I + F dt) P (I + F dt)' + diag(`noise`) dt. Noise per second.
  void propagate(const BasicErrorDynamics<Real>& f, double dt, const Vector& noise) {
    constexpr auto rows = std::make_index_sequence<9>{};
    const BasicErrorDynamics<Real> g = dt * f;
    Eigen::Matrix<Real, stored, 9> right = p_.template leftCols<9>();  // P (I + F dt)'
    add_products(right, g, p_, rows);
    Eigen::Matrix<Real, 10, stored> left = Eigen::Matrix<Real, 10, stored>::Zero();
    left.template topRows<9>() = right.transpose();
    Eigen::Matrix<Real, 10, 9> both = left.template leftCols<9>();  // (I + F dt) P (I + F dt)'
    add_products(both, g, left, rows);

    p_.template topRightCorner<9, stored - 9>() = left.template topRightCorner<9, stored - 9>();
    p_.template bottomLeftCorner<stored - 9, 9>() = right.template bottomRows<stored - 9>();
    for (int i = 0; i < 9; ++i)
      for (int j = 0; j <= i; ++j) p_(i, j) = p_(j, i) = (both(i, j) + both(j, i)) / 2;
    p_.diagonal() += noise * dt;
  }

  /// P h' and the innovation's variance for a measurement z = h x + noise.
  struct Row {
    Vector cross;   ///< P h'
    Real variance;  ///< of the innovation, h P h' + r
  };
  Row row(const Vector& h, const Real& noise_variance) const {
    const Vector cross = p_.lazyProduct(h);
    return {cross, h.dot(cross) + noise_variance};
  }

  /// Updates with the measurement and returns the correction of the errors, for feedback. With
  /// K = P h' / s and s the variance of the innovation, Joseph's form (I - K h) P (I - K h)' + K r
  /// K' equals P - P h' (P h')' / s. This subtracts a square, so P stays symmetric to the last bit.
  Vector update(const Row& row, const Real& innovation) {
    using lanes::sqrt;
    const Vector root = row.cross / sqrt(row.variance);
    for (int j = 0; j < stored; ++j) p_.col(j) -= root(j) * root;
    return innovation / row.variance * row.cross;
  }

  /// Adds these standard deviations to velocity and attitude, each axis.
  void loosen(double velocity_sigma_mps, double angle_sigma_rad) {
    p_.diagonal().template segment<3>(velocity_error).array() +=
        velocity_sigma_mps * velocity_sigma_mps;
    p_.diagonal().template segment<3>(phi).array() += angle_sigma_rad * angle_sigma_rad;
  }

  /// Adds this standard deviation to north and east, of a vehicle at this place.
  void loosen_position(const frame::Position& at, double sigma_m) {
    const frame::LocalEarth earth = frame::local_earth(at.latitude_rad, at.height_m);
    const double north_rad = sigma_m / (earth.meridian_radius_m + at.height_m);
    const double east_rad =
        sigma_m / ((earth.transverse_radius_m + at.height_m) * earth.cos_latitude);
    p_(position_error, position_error) += north_rad * north_rad;
    p_(position_error + 1, position_error + 1) += east_rad * east_rad;
  }

  /// Adds these standard deviations to the biases of gyros and accelerometers, each axis.
  void loosen_biases(double gyro_sigma_radps, double accel_sigma_mps2) {
    p_.diagonal().template segment<3>(gyro_bias).array() += gyro_sigma_radps * gyro_sigma_radps;
    p_.diagonal().template segment<3>(accel_bias).array() += accel_sigma_mps2 * accel_sigma_mps2;
  }

  const Covariance& covariance() const { return p_; }
  Covariance& covariance() { return p_; }

 private:
  /// to += from G', column by column. Each column is one sum over the nonzero entries of G.
  template <class To, class From, std::size_t... Row>
  static void add_products(To& to, const BasicErrorDynamics<Real>& g, const From& from,
                           std::index_sequence<Row...>) {
    (add_product<Row>(to, g, from, std::make_index_sequence<error_dynamics_pattern[Row].entries>{}),
     ...);
  }
  template <std::size_t Row, class To, class From, std::size_t... I>
  static void add_product(To& to, const BasicErrorDynamics<Real>& g, const From& from,
                          std::index_sequence<I...>) {
    constexpr auto& columns = error_dynamics_pattern[Row].columns;
    to.col(Row) += ((g(Row, columns[I]) * from.col(columns[I])) + ...);
  }

  Covariance p_;
};

}  // namespace drydock::navigation
