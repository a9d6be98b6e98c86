#include "estimators/roll/roll_watch.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::roll {

namespace {

/// What the windows say below this many sigmas is nothing.
constexpr double suspicion = 2.5;

}  // namespace

void RollWatch::add(const Evidence& epoch, double dt_s) {
  for (Window& window : windows_) {
    const double kept = std::exp(-dt_s / window.span_s);
    window.score = kept * window.score + epoch.score;
    window.information = kept * window.information + epoch.information;
    window.variance = kept * kept * window.variance + epoch.information;
  }
}

double RollWatch::Window::statistic() const {
  return variance > 0 ? score / std::sqrt(variance) : 0;
}

const RollWatch::Window& RollWatch::loudest() const {
  return *std::ranges::max_element(
      windows_, {}, [](const Window& window) { return std::abs(window.statistic()); });
}

double RollWatch::statistic() const { return loudest().statistic(); }

double RollWatch::error_rad() const { return loudest().error_rad(); }

double RollWatch::suspected_variance() const {
  double most = 0;
  for (const Window& window : windows_) {
    const double noise = std::pow(suspicion / window.statistic(), 2);  // share of the square
    if (noise < 1) most = std::max(most, (1 - noise) * std::pow(window.error_rad(), 2));
  }
  return most;
}

}  // namespace drydock::roll
