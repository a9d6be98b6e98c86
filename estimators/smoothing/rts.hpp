#pragma once

#include <Eigen/Cholesky>
#include <span>
#include <vector>

/// The backward pass of a fixed-interval smoother: H. E. Rauch, F. Tung, C. T. Striebel, Maximum
/// likelihood estimates of linear dynamic systems, AIAA Journal 3 (1965) 1445. Equation numbers:
/// docs/estimators/smoothing.md.
namespace drydock::smoothing {

/// One epoch of a forward filter that feeds its corrections back into its state: x is the state
/// after the epoch's measurements, and x minus `correction` is the state before them.
template <int N>
struct RtsStep {
  Eigen::Matrix<double, N, N>
      transition;  ///< of the errors, from the epoch before; any for the first
  Eigen::Matrix<double, N, N> predicted;   ///< covariance before the measurements
  Eigen::Matrix<double, N, N> filtered;    ///< covariance after them
  Eigen::Matrix<double, N, 1> correction;  ///< sum of what the measurements added to the state
};

/// What the whole record adds to the filter's state of an epoch, and the covariance then.
template <int N>
struct RtsResult {
  Eigen::Matrix<double, N, 1> correction;
  Eigen::Matrix<double, N, N> covariance;
};

/// P- inverse times A. States are scaled by their own sigma, since radians of latitude stand beside
/// metres. A state without variance is left alone.
template <int N>
Eigen::Matrix<double, N, N> solved(const Eigen::Matrix<double, N, N>& p,
                                   const Eigen::Matrix<double, N, N>& a) {
  Eigen::Matrix<double, N, 1> scale;
  for (int i = 0; i < N; ++i) scale(i) = p(i, i) > 0 ? 1 / std::sqrt(p(i, i)) : 0;
  Eigen::Matrix<double, N, N> scaled = scale.asDiagonal() * p * scale.asDiagonal();
  for (int i = 0; i < N; ++i)
    if (scale(i) == 0) scaled(i, i) = 1;
  return scale.asDiagonal() * scaled.ldlt().solve(scale.asDiagonal() * a);
}

/// Eq. (S3) to (S5), from the last epoch to the first.
template <int N>
std::vector<RtsResult<N>> smooth(std::span<const RtsStep<N>> steps) {
  std::vector<RtsResult<N>> results(steps.size());
  if (steps.empty()) return results;
  results.back() = {Eigen::Matrix<double, N, 1>::Zero(), steps.back().filtered};
  for (std::size_t k = steps.size() - 1; k-- > 0;) {
    const RtsStep<N>&now = steps[k], &next = steps[k + 1];
    const Eigen::Matrix<double, N, N> cross = next.transition * now.filtered;
    const Eigen::Matrix<double, N, N> gain = solved<N>(next.predicted, cross).transpose();
    const RtsResult<N>& after = results[k + 1];
    results[k].correction = gain * (after.correction + next.correction);
    const Eigen::Matrix<double, N, N> p =
        now.filtered + gain * (after.covariance - next.predicted) * gain.transpose();
    results[k].covariance = (p + p.transpose()) / 2;
  }
  return results;
}

}  // namespace drydock::smoothing
