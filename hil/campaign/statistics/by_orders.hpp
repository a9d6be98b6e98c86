#pragma once

#include <cstddef>
#include <span>
#include <vector>

/// How likely a figure of few runs is where the parameter does not matter: each order of the values
/// is then equally likely (permutation test; Good, Permutation, Parametric and Bootstrap Tests of
/// Hypotheses). No approximation for a few runs says this: 1, 2, 3 over 1, 2, 3 are in order, or
/// in the opposite one, in two of six.
namespace drydock::campaign {

/// More values have too many orders to try them all.
inline constexpr std::size_t most_ordered = 8;

/// The share of all orders of y in which the ranks' correlation is as far from 0. At most
/// `most_ordered` values.
double correlation_by_orders(std::span<const double> rank_x, std::vector<double> rank_y);

/// The same for the sum of squares between levels.
double effect_by_orders(std::span<const std::size_t> level, std::vector<double> values);

/// The least that any figure of so many values can have: one order of all, and those that differ
/// from it by equal values of x only. Twice that, because the opposite order is as far.
double least_of_correlation(std::span<const double> rank_x);

/// The same for levels of these sizes: those of one size may change places.
double least_of_effect(std::span<const std::size_t> sizes);

}  // namespace drydock::campaign
