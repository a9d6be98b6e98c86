#pragma once

#include <Eigen/Dense>
#include <cmath>

namespace drydock::consistency {

/// Recursive least squares with forgetting: y = sum x_k a_k + white noise. A prior holds what the
/// data cannot tell.
template <int N>
class ConstantFit {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;

  /// `prior_sigma`: of each a_k around 0. `floor`: 1 sigma of y at least. `memory`: how much of the
  /// past stays with each sample.
  ConstantFit(const Vector& prior_sigma, double floor, double memory)
      : prior_(prior_sigma.cwiseAbs2().cwiseInverse()), floor_(floor), memory_(memory) {}

  /// `sigma`: of an error of this y that is not in the others.
  void add(double y, const Vector& x, double sigma = 0) {
    const double weight = floor_ * floor_ / (floor_ * floor_ + sigma * sigma);
    information_ = memory_ * information_ + weight * x * x.transpose();
    right_ = memory_ * right_ + weight * y * x;
    squares_ = memory_ * squares_ + weight * y * y;
    count_ = memory_ * count_ + weight;
  }

  struct Answer {
    Vector value = Vector::Zero();
    Eigen::Matrix<double, N, N> covariance = Eigen::Matrix<double, N, N>::Zero();
    double sigma(int k) const { return std::sqrt(covariance(k, k)); }
    /// Of the y that belongs to x.
    double sigma_of(const Vector& x) const { return std::sqrt(x.dot(covariance * x)); }
    /// Less is known of a_k than the data seem to tell, and so of those that go with it.
    void widen(int k, double sigma) {
      const Vector with = covariance.col(k) / covariance(k, k);
      covariance += (sigma * sigma - covariance(k, k)) * with * with.transpose();
    }
  };
  Answer solve() const {
    const Answer rough = solve_for(floor_ * floor_);
    const double left =
        squares_ - 2 * rough.value.dot(right_) + rough.value.dot(information_ * rough.value);
    return solve_for(std::max(floor_ * floor_, left / std::max(1.0, count_ - N)));
  }

  /// As many samples as are remembered.
  double count() const { return count_; }

 private:
  Answer solve_for(double variance) const {
    const Eigen::Matrix<double, N, N> whole =
        information_ + variance * Eigen::Matrix<double, N, N>(prior_.asDiagonal());
    const Eigen::Matrix<double, N, N> inverse = whole.inverse();
    return {inverse * right_, variance * inverse};
  }

  Vector prior_;
  double floor_, memory_;
  Eigen::Matrix<double, N, N> information_ = Eigen::Matrix<double, N, N>::Zero();
  Vector right_ = Vector::Zero();
  double squares_ = 0, count_ = 0;
};

}  // namespace drydock::consistency
