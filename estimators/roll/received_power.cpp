#include "estimators/roll/received_power.hpp"

#include <cmath>
#include <limits>

namespace drydock::roll {
namespace {

double density(double z) { return std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi); }

/// Probability above z.
double above(double z) { return 0.5 * std::erfc(z / std::numbers::sqrt2); }

}  // namespace

std::optional<Interval> interval_of(const AntennaOptions& antenna, const Signal& signal) {
  if (signal.power) {
    const double half_a_step = std::pow(10, antenna.resolution_db / 20);
    return Interval{*signal.power / half_a_step, *signal.power * half_a_step};
  }
  if (!antenna.tracking_limit) return std::nullopt;
  return Interval{-std::numeric_limits<double>::infinity(), *antenna.tracking_limit};
}

Moments within(const Interval& z) {
  if (z.low == z.high) return {-0.5 * z.low * z.low, z.low, 1};  // eq. (30)
  // A difference of small tails has less rounding error than a difference of numbers near 1.
  const double probability =
      z.low > 0 ? above(z.low) - above(z.high) : above(-z.high) - above(-z.low);
  const double low = density(z.low), high = density(z.high);
  const double mean = (low - high) / probability;
  const auto weighted = [](double at, double d) { return std::isfinite(at) ? at * d : 0; };
  const double bend = (weighted(z.high, high) - weighted(z.low, low)) / probability;
  return {std::log(probability), mean, bend + mean * mean};
}

}  // namespace drydock::roll
