#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace drydock::campaign {

/// Ranks from 1 of the order statistics that enclose a quantile of the distribution.
struct RankBounds {
  std::optional<std::size_t> low, high;  ///< empty: there are too few values for this bound
};

/// Bounds of the quantile `p` of `n` independent values, whatever their distribution: the number of
/// values below it is binomial. Each side is wrong with at most half of 1 - confidence.
RankBounds quantile_ranks(std::size_t n, double p, double confidence);

struct Quantile {
  double p = 0;
  double value = 0;  ///< the smallest value that at least the share p does not exceed
  std::optional<double> low{}, high{};
};

/// `sorted`: growing, at least one.
Quantile quantile_of(std::span<const double> sorted, double p, double confidence);

}  // namespace drydock::campaign
