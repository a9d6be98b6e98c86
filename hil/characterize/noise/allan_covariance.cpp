#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "hil/characterize/noise/allan_curve.hpp"

namespace drydock::characterize {
namespace {

using std::int64_t;

/// Covariance of the differences of clusters d_j(t), d_k(t + lag), docs/sensors/characterize.md
/// (4). Each is a second difference of the integral, so the covariance is a fourth difference of
/// the integral's generalised autocovariance s, (5). The unit of time is one sample.
class DifferenceCovariance {
 public:
  DifferenceCovariance(const NoiseModel& model, double period_s)
      : white_(model.density * model.density / period_s),
        walk_(model.walk * model.walk * period_s),
        phase_(model.quantisation * model.quantisation / (period_s * period_s)),
        markov_(model.instability * model.instability),
        correlation_(markov_ > 0 ? model.correlation_s / period_s : 1) {}

  /// `stride` is the step of the sum over lags. A white integral is correlated at single lags only.
  /// The sum of squares counts such a lag `stride` times, so its covariance is divided by
  /// sqrt(stride).
  double at(int64_t lag, int64_t j, int64_t k, double stride) const {
    constexpr std::array<int64_t, 3> difference{1, -2, 1};
    int64_t linear = 0, hits = 0;
    std::uint64_t cubic = 0;  // modulo 2^64: cubes of any size cancel exactly
    double exponential = 0;
    for (int64_t a = 0; a < 3; ++a) {
      for (int64_t b = 0; b < 3; ++b) {
        const int64_t weight = difference[a] * difference[b];
        const int64_t distance = std::abs(lag + (a - 1) * j - (b - 1) * k);
        linear += weight * distance;
        const auto d = static_cast<std::uint64_t>(distance);
        cubic += static_cast<std::uint64_t>(weight) * d * d * d;
        hits += distance == 0 ? weight : 0;
        if (markov_ > 0)
          exponential +=
              static_cast<double>(weight) * std::exp(-static_cast<double>(distance) / correlation_);
      }
    }
    const double sum =
        -white_ / 2 * static_cast<double>(linear) +
        walk_ / 12 * static_cast<double>(static_cast<int64_t>(cubic)) +
        phase_ * static_cast<double>(hits) / std::sqrt(stride) -
        markov_ * correlation_ * (correlation_ * exponential + static_cast<double>(linear));
    return sum / (2 * static_cast<double>(j) * static_cast<double>(k));
  }

  /// The covariance is zero, or nearly zero, beyond this lag.
  int64_t reach(int64_t j, int64_t k) const {
    constexpr double memories = 4;
    return j + k + (markov_ > 0 ? static_cast<int64_t>(memories * correlation_) : 0);
  }

 private:
  double white_, walk_, phase_, markov_, correlation_;
};

/// Number of places t for which both differences exist, at t and at t + lag.
double pairs(int64_t n, int64_t j, int64_t k, int64_t lag) {
  return static_cast<double>(
      std::max<int64_t>(0, std::min(n - j, n - k - lag) - std::max(j, k - lag) + 1));
}

double element(const DifferenceCovariance& differences, int64_t n, int64_t j, int64_t k) {
  // The covariance is smooth between its kinks, which are at multiples of j.
  constexpr int64_t steps_per_cluster = 16;
  const int64_t stride = std::max<int64_t>(1, j / steps_per_cluster);
  const int64_t reach = std::min(n, differences.reach(j, k)) / stride * stride;
  double sum = 0;
  for (int64_t lag = -reach; lag <= reach; lag += stride) {
    const double c = differences.at(lag, j, k, static_cast<double>(stride));
    sum += c * c * pairs(n, j, k, lag);
  }
  const double places = static_cast<double>(n + 1 - 2 * j) * static_cast<double>(n + 1 - 2 * k);
  return 2 * sum * static_cast<double>(stride) / places;
}

}  // namespace

Eigen::MatrixXd covariance(const AllanCurve& curve, const NoiseModel& model) {
  const DifferenceCovariance differences(model, curve.period_s);
  const auto size = static_cast<Eigen::Index>(curve.samples.size());
  const auto n = static_cast<int64_t>(curve.readings);
  Eigen::MatrixXd all(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index l = i; l < size; ++l) {
      all(i, l) = all(l, i) =
          element(differences, n, static_cast<int64_t>(curve.samples[static_cast<std::size_t>(i)]),
                  static_cast<int64_t>(curve.samples[static_cast<std::size_t>(l)]));
    }
  }
  return all;
}

}  // namespace drydock::characterize
