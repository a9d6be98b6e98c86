#include "estimators/roll/roll_watch.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::roll {

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

double RollWatch::error_rad() const {
  const Window& window = loudest();
  return window.information > 0 ? window.score / window.information : 0;
}

}  // namespace drydock::roll
