#include "hil/campaign/statistics/sensitivity.hpp"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "hil/campaign/statistics/by_orders.hpp"
#include "hil/campaign/statistics/exact_moments.hpp"
#include "hil/campaign/statistics/ranks.hpp"

namespace drydock::campaign {
namespace {

double correlation_p_value(double rho, std::span<const double> rank_x,
                           const std::vector<double>& rank_y) {
  if (rank_x.size() <= most_ordered) return correlation_by_orders(rank_x, rank_y);
  const double least = least_of_correlation(rank_x);
  if (std::abs(rho) >= 1) return least;
  const double freedom = static_cast<double>(rank_x.size()) - 2;
  const double t = std::abs(rho) * std::sqrt(freedom / (1 - rho * rho));
  const boost::math::students_t_distribution<> student(freedom);
  return std::max(least, 2 * cdf(complement(student, t)));
}

/// `within` 0: the levels explain everything.
double effect_p_value(double between, double within, const std::vector<ExactMoments>& groups,
                      double n) {
  std::vector<std::size_t> sizes;
  sizes.reserve(groups.size());
  for (const auto& group : groups) sizes.push_back(static_cast<std::size_t>(group.count()));
  const double least = least_of_effect(sizes), levels = static_cast<double>(groups.size());
  if (within <= 0) return least;
  const double f = (between / (levels - 1)) / (within / (n - levels));
  const boost::math::fisher_f_distribution<> fisher(levels - 1, n - levels);
  return std::max(least, cdf(complement(fisher, f)));
}

}  // namespace

std::optional<RankCorrelation> rank_correlation(std::span<const double> x,
                                                std::span<const double> y) {
  if (x.size() < 3) return std::nullopt;
  const auto rank_x = ranks_of(x), rank_y = ranks_of(y);
  const double middle = (static_cast<double>(x.size()) + 1) / 2;
  double xx = 0, yy = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double a = rank_x[i] - middle, b = rank_y[i] - middle;
    xx += a * a, yy += b * b, xy += a * b;
  }
  if (xx == 0 || yy == 0) return std::nullopt;
  const double rho = std::clamp(xy / std::sqrt(xx * yy), -1.0, 1.0);
  return RankCorrelation{rho, correlation_p_value(rho, rank_x, rank_y)};
}

std::optional<LevelEffect> level_effect(std::span<const std::size_t> level,
                                        std::span<const double> values) {
  std::vector<ExactMoments> groups;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (groups.size() <= level[i]) groups.resize(level[i] + 1);
    groups[level[i]].add(values[i]);
  }
  std::erase_if(groups, [](const ExactMoments& group) { return group.count() == 0; });
  if (groups.size() < 2 || values.size() <= groups.size()) return std::nullopt;
  ExactMoments all;
  double within = 0;
  for (const auto& group : groups) {
    all.merge(group);
    within += group.squared_distances();
  }
  const double total = all.squared_distances();
  if (!(total > 0)) return std::nullopt;
  const double between = std::max(0.0, total - within);
  const double p =
      values.size() <= most_ordered
          ? effect_by_orders(level, {values.begin(), values.end()})
          : effect_p_value(between, within, groups, static_cast<double>(values.size()));
  return LevelEffect{between / total, p};
}

}  // namespace drydock::campaign
