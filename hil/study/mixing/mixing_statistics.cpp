#include "hil/study/mixing/mixing_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::study {
namespace {

/// Calls `take(i)` for every point in [from_s, to_s]. Point i is at the end of its interval.
template <class Take>
void for_points(double from_s, double to_s, Take&& take) {
  for (std::size_t i = 0; i < mixing_points; ++i) {
    const double t = static_cast<double>(i + 1) * mixing_point_spacing_s;
    if (t >= from_s && t <= to_s) take(i);
  }
}

}  // namespace

void MixingStatistics::add(const MixingOutcome& outcome) {
  roll.add(outcome.roll_deg);
  pitch.add(outcome.pitch_deg);
  nees_sum += outcome.nees;
}

double MixingStatistics::cruise_deviation(const Ensemble& error) {
  double sum = 0;
  std::size_t points = 0;
  for_points(300, 560, [&](std::size_t i) {
    sum += error.deviation(i);
    ++points;
  });
  return sum / static_cast<double>(points);
}

double MixingStatistics::mean_peak(const Ensemble& error, double from_s, double to_s) {
  double peak = 0;
  for_points(from_s, to_s, [&](std::size_t i) { peak = std::max(peak, std::abs(error.mean(i))); });
  return peak;
}

double MixingStatistics::largest_deviation() const {
  double largest = 0;
  for (std::size_t i = 0; i < mixing_points; ++i)
    largest = std::max({largest, roll.deviation(i), pitch.deviation(i)});
  return largest;
}

}  // namespace drydock::study
