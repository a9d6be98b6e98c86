#include "hil/compare/gaps.hpp"

#include <algorithm>

namespace drydock::compare {

Gaps gaps_of(const std::vector<measurement::Stamp>& valid_at) {
  if (valid_at.size() < 2) return {};
  std::vector<measurement::Stamp::duration> steps;
  for (std::size_t i = 1; i < valid_at.size(); ++i) steps.push_back(valid_at[i] - valid_at[i - 1]);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::ranges::nth_element(steps, middle);
  const auto usual = *middle;
  Gaps gaps;
  gaps.count = static_cast<std::uint64_t>(
      std::ranges::count_if(steps, [&](auto step) { return step > 3 * usual; }));
  gaps.longest_s = measurement::seconds(*std::ranges::max_element(steps));
  return gaps;
}

}  // namespace drydock::compare
