#include "hil/characterize/compare/track.hpp"

#include <algorithm>

namespace drydock::characterize {

Track::Track(const Samples& samples, const std::vector<Eigen::Vector3d>& values,
             measurement::Stamp zero) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double t = measurement::seconds(samples.origins[i].valid_at - zero);
    if (!values[i].allFinite() || (!t_s_.empty() && t <= t_s_.back())) continue;
    t_s_.push_back(t);
    values_.push_back(values[i]);
  }
  if (empty()) return;
  std::vector<double> steps;
  for (std::size_t i = 1; i < t_s_.size(); ++i) steps.push_back(t_s_[i] - t_s_[i - 1]);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::ranges::nth_element(steps, middle);
  period_s_ = *middle;
}

std::optional<Eigen::Vector3d> Track::at(double t_s) const {
  if (empty() || t_s < t_s_.front() || t_s > t_s_.back()) return std::nullopt;
  const auto after =
      std::max<std::ptrdiff_t>(1, std::ranges::lower_bound(t_s_, t_s) - t_s_.begin());
  const auto i = static_cast<std::size_t>(after);
  const double step = t_s_[i] - t_s_[i - 1];
  constexpr double longest_in_periods = 1.5;
  if (step > longest_in_periods * period_s_) return std::nullopt;
  return values_[i - 1] + (t_s - t_s_[i - 1]) / step * (values_[i] - values_[i - 1]);
}

}  // namespace drydock::characterize
