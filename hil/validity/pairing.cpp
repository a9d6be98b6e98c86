#include "hil/validity/pairing.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace drydock::validity {
namespace {

/// Number of samples to consider on each side of the nearest.
constexpr std::ptrdiff_t reach = 12;
constexpr std::size_t width = 2 * reach + 1;
/// Cost of a measurement without a sample. It is larger than any error, so this is the last choice.
constexpr double alone_ns = 1e12;
constexpr double never = std::numeric_limits<double>::infinity();

/// The cheapest assignments of all measurements up to one, by the sample that this measurement
/// takes. If it takes none, by the last sample taken before.
struct Row {
  std::ptrdiff_t first = 0;  ///< index of the sample at place 0
  std::array<double, width> cost{};
  std::array<std::int8_t, width> before{};  ///< place in the previous row
  std::array<bool, width> alone{};
};

std::ptrdiff_t nearest(std::span<const Stamp> samples, Stamp to) {
  const auto after = std::ranges::lower_bound(samples, to) - samples.begin();
  if (after == 0) return 0;
  const auto n = std::ssize(samples);
  if (after == n) return n - 1;
  const auto at = [&](std::ptrdiff_t i) { return samples[static_cast<std::size_t>(i)]; };
  return at(after) - to < to - at(after - 1) ? after : after - 1;
}

Row next_row(const Row* last, std::span<const Stamp> samples, Stamp valid_at) {
  Row row;
  row.first = nearest(samples, valid_at) - reach;
  if (last) row.first = std::max(row.first, last->first);
  row.cost.fill(never);
  double least = last ? never : 0;  // least cost of those that took an earlier sample
  std::int8_t place = -1;
  std::ptrdiff_t seen = 0;
  for (std::size_t k = 0; k < width; ++k) {
    const std::ptrdiff_t sample = row.first + static_cast<std::ptrdiff_t>(k);
    while (last && seen < static_cast<std::ptrdiff_t>(width) && last->first + seen < sample) {
      if (const double cost = last->cost[static_cast<std::size_t>(seen)]; cost < least) {
        least = cost;
        place = static_cast<std::int8_t>(seen);
      }
      ++seen;
    }
    if (sample < 0 || sample >= std::ssize(samples)) continue;
    const auto error = (valid_at - samples[static_cast<std::size_t>(sample)]).count();
    row.cost[k] = least + std::abs(static_cast<double>(error));
    row.before[k] = place;
    const std::ptrdiff_t same = last ? sample - last->first : -1;
    if (same < 0 || same >= static_cast<std::ptrdiff_t>(width)) continue;
    if (const double cost = last->cost[static_cast<std::size_t>(same)] + alone_ns;
        cost < row.cost[k]) {
      row.cost[k] = cost;
      row.before[k] = static_cast<std::int8_t>(same);
      row.alone[k] = true;
    }
  }
  return row;
}

}  // namespace

std::vector<std::optional<std::size_t>> pair(std::span<const Stamp> valid_at,
                                             std::span<const Stamp> sampled_at) {
  std::vector<std::optional<std::size_t>> pairs(valid_at.size());
  if (sampled_at.empty() || valid_at.empty()) return pairs;
  std::vector<Row> rows;
  rows.reserve(valid_at.size());
  for (const Stamp valid : valid_at)
    rows.push_back(next_row(rows.empty() ? nullptr : &rows.back(), sampled_at, valid));

  auto place = static_cast<std::size_t>(std::ranges::min_element(rows.back().cost) -
                                        rows.back().cost.begin());
  for (std::size_t i = rows.size(); i-- > 0;) {
    const Row& row = rows[i];
    if (!row.alone[place])
      pairs[i] = static_cast<std::size_t>(row.first + static_cast<std::ptrdiff_t>(place));
    place = static_cast<std::size_t>(row.before[place]);
  }
  return pairs;
}

}  // namespace drydock::validity
