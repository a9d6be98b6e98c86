#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace drydock::campaign {

/// Spearman's rank correlation, and how likely a correlation this far from 0 is where there is
/// none: two-sided, by all orders of up to 8 values, else by Student's t with n - 2 degrees of
/// freedom.
struct RankCorrelation {
  double rho = 0, p_value = 1;
};

/// Empty: fewer than three pairs, or one side does not vary.
std::optional<RankCorrelation> rank_correlation(std::span<const double> x,
                                                std::span<const double> y);

/// How much of the variance lies between the levels of a parameter (eta squared), and how likely
/// this much is where the levels do not matter: by all orders of up to 8 values, else by Fisher's F
/// (analysis of variance).
struct LevelEffect {
  double share = 0, p_value = 1;
};

/// `level`: of each value, from 0. Empty: fewer than two levels have values, no value is spare, or
/// all values are equal.
std::optional<LevelEffect> level_effect(std::span<const std::size_t> level,
                                        std::span<const double> values);

}  // namespace drydock::campaign
