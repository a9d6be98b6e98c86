#include "hil/characterize/noise/allan_curve.hpp"

namespace drydock::characterize {

namespace {
constexpr std::size_t fewest_clusters = 9;
}

AllanCurve allan_curve(std::span<const double> readings, double period_s) {
  AllanCurve curve{period_s, readings.size(), {}, {}};
  if (readings.empty()) return curve;
  // Subtracts the first reading, so that the integral and its rounding errors stay small.
  std::vector<double> integral(readings.size() + 1, 0.0);
  for (std::size_t i = 0; i < readings.size(); ++i)
    integral[i + 1] = integral[i] + (readings[i] - readings[0]);
  for (std::size_t m = 1; m * fewest_clusters <= readings.size(); m *= 2) {
    double squares = 0;
    const std::size_t places = readings.size() + 1 - 2 * m;
    for (std::size_t k = 0; k < places; ++k) {
      const double step = integral[k + 2 * m] - 2 * integral[k + m] + integral[k];
      squares += step * step;
    }
    const auto length = static_cast<double>(m);
    curve.samples.push_back(m);
    curve.variance.push_back(squares / (2 * length * length * static_cast<double>(places)));
  }
  return curve;
}

}  // namespace drydock::characterize
