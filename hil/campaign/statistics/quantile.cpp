#include "hil/campaign/statistics/quantile.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>

namespace drydock::campaign {
namespace {

/// The smallest k whose probability of at most k successes is `share` or more.
std::size_t binomial_rank(std::size_t n, double p, double share) {
  const boost::math::binomial_distribution<> successes(static_cast<double>(n), p);
  std::size_t low = 0, high = n;
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (cdf(successes, static_cast<double>(middle)) >= share)
      high = middle;
    else
      low = middle + 1;
  }
  return low;
}

}  // namespace

RankBounds quantile_ranks(std::size_t n, double p, double confidence) {
  const double risk = (1 - confidence) / 2;
  RankBounds ranks;
  // P(values below < low) is at most the risk, and so is P(values below >= high).
  if (const auto low = binomial_rank(n, p, risk); low >= 1) ranks.low = low;
  if (const auto high = binomial_rank(n, p, 1 - risk) + 1; high <= n) ranks.high = high;
  return ranks;
}

Quantile quantile_of(std::span<const double> sorted, double p, double confidence) {
  const std::size_t n = sorted.size();
  const auto rank = static_cast<std::size_t>(std::ceil(p * static_cast<double>(n)));
  Quantile quantile{.p = p, .value = sorted[std::clamp<std::size_t>(rank, 1, n) - 1]};
  const auto ranks = quantile_ranks(n, p, confidence);
  if (ranks.low) quantile.low = sorted[*ranks.low - 1];
  if (ranks.high) quantile.high = sorted[*ranks.high - 1];
  return quantile;
}

}  // namespace drydock::campaign
