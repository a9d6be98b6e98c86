#include "estimators/roll/peak_finder.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/frame/attitude.hpp"

namespace drydock::roll {
namespace {

/// The rate of turn is the mean over at most `rate_epochs`. Slower turns than
/// `slowest_epochs_per_turn` have no peaks, because the memory is too short for them.
constexpr std::size_t rate_epochs = 8;
constexpr double slowest_epochs_per_turn = 64;

}  // namespace

double PeakFinder::epochs_per_turn() const {
  const std::size_t span = std::min(rate_epochs, count_ - 1);
  const double turned = std::abs(sample(count_ - 1).gyro_rad - sample(count_ - 1 - span).gyro_rad);
  return 2 * std::numbers::pi * static_cast<double>(span) / std::max(turned, 1e-9);
}

std::optional<Peak> PeakFinder::add(const PeakOptions& options, double power, double time_s,
                                    double gyro_rad, double strongest_roll_rad) {
  sample(count_++) = {power, 0, time_s, gyro_rad, strongest_roll_rad};
  if (count_ < 2) return std::nullopt;
  const double per_turn = epochs_per_turn();
  if (per_turn > slowest_epochs_per_turn) return std::nullopt;

  const auto half = std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(per_turn / 6)), 1,
                                            static_cast<std::size_t>(options.longest_average) / 2);
  if (count_ < 2 * half + 1) return std::nullopt;
  const std::size_t middle = count_ - 1 - half;
  double sum = 0;
  for (std::size_t i = middle - half; i <= middle + half; ++i) sum += sample(i).power;
  sample(middle).average = sum / static_cast<double>(2 * half + 1);

  const auto reach = static_cast<std::size_t>(std::max(1L, std::lround(per_turn / 4)));
  if (middle < half + 2 * reach) return std::nullopt;
  if (!is_peak(middle - reach, reach, options.least_height)) return std::nullopt;
  return dated(middle - reach);
}

bool PeakFinder::is_peak(std::size_t middle, std::size_t reach, double least_height) const {
  const double top = sample(middle).average;
  double lowest = top;
  for (std::size_t i = middle - reach; i <= middle + reach; ++i) {
    if (sample(i).average > top || (i < middle && sample(i).average == top)) return false;
    lowest = std::min(lowest, sample(i).average);
  }
  return top - lowest >= least_height;
}

Peak PeakFinder::dated(std::size_t middle) const {
  const Sample &before = sample(middle - 1), &at = sample(middle), &after = sample(middle + 1);
  const double bend = before.average - 2 * at.average + after.average;
  const double part =
      bend < 0 ? std::clamp(0.5 * (before.average - after.average) / bend, -0.5, 0.5) : 0;
  const Sample& beside = part < 0 ? before : after;
  const double share = std::abs(part);
  const auto between = [&](double a, double b) { return a + share * (b - a); };
  return {0, between(at.time_s, beside.time_s), between(at.gyro_rad, beside.gyro_rad),
          frame::wrap_pi(at.strongest_roll_rad + share * frame::wrap_pi(beside.strongest_roll_rad -
                                                                        at.strongest_roll_rad))};
}

}  // namespace drydock::roll
