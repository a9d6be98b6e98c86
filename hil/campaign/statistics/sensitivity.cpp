#include "hil/campaign/statistics/sensitivity.hpp"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "hil/campaign/statistics/exact_moments.hpp"
#include "hil/campaign/statistics/ranks.hpp"

namespace drydock::campaign {
namespace {

double correlation_p_value(double rho, std::size_t n) {
  const double freedom = static_cast<double>(n) - 2;
  if (std::abs(rho) >= 1) return 0;
  const double t = std::abs(rho) * std::sqrt(freedom / (1 - rho * rho));
  return 2 * cdf(complement(boost::math::students_t_distribution<>(freedom), t));
}

/// `within` 0: the levels explain everything.
double effect_p_value(double between, double within, double levels, double n) {
  if (within <= 0) return 0;
  const double f = (between / (levels - 1)) / (within / (n - levels));
  return cdf(complement(boost::math::fisher_f_distribution<>(levels - 1, n - levels), f));
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
  return RankCorrelation{rho, correlation_p_value(rho, x.size())};
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
  return LevelEffect{between / total,
                     effect_p_value(between, within, static_cast<double>(groups.size()),
                                    static_cast<double>(values.size()))};
}

}  // namespace drydock::campaign
