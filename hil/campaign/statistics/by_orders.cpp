#include "hil/campaign/statistics/by_orders.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace drydock::campaign {
namespace {

/// The share of all orders of `values` whose figure is at least that of the given order.
template <class Figure>
double share_of_orders(std::vector<double> values, const Figure& figure_of) {
  const double wanted = figure_of(values);
  const double least = wanted - 1e-9 * std::abs(wanted);  // orders that are alike round differently
  std::ranges::sort(values);
  std::size_t orders = 0, as_far = 0;
  do {
    ++orders;
    as_far += figure_of(values) >= least;
  } while (std::ranges::next_permutation(values).found);
  return static_cast<double>(as_far) / static_cast<double>(orders);
}

/// The logarithm of the product of the factorials.
template <class Counts>
double log_factorials(const Counts& counts) {
  double sum = 0;
  for (const auto& [key, count] : counts) sum += std::lgamma(static_cast<double>(count) + 1);
  return sum;
}

}  // namespace

double correlation_by_orders(std::span<const double> rank_x, std::vector<double> rank_y) {
  const double middle = (static_cast<double>(rank_x.size()) + 1) / 2;
  return share_of_orders(std::move(rank_y), [&](const std::vector<double>& y) {
    double product = 0;
    for (std::size_t i = 0; i < y.size(); ++i) product += (rank_x[i] - middle) * (y[i] - middle);
    return std::abs(product);
  });
}

double effect_by_orders(std::span<const std::size_t> level, std::vector<double> values) {
  double mean = 0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  return share_of_orders(std::move(values), [&](const std::vector<double>& of) {
    std::map<std::size_t, std::pair<double, double>> sums;  // of each level: sum and count
    for (std::size_t i = 0; i < of.size(); ++i) {
      sums[level[i]].first += of[i] - mean;
      sums[level[i]].second += 1;
    }
    double between = 0;
    for (const auto& [key, sum] : sums) between += sum.first * sum.first / sum.second;
    return between;
  });
}

double least_of_correlation(std::span<const double> rank_x) {
  std::map<double, std::size_t> equal;
  for (const double rank : rank_x) ++equal[rank];
  const double all = std::lgamma(static_cast<double>(rank_x.size()) + 1);
  return 2 * std::exp(log_factorials(equal) - all);
}

double least_of_effect(std::span<const std::size_t> sizes) {
  std::map<std::size_t, std::size_t> of_one_size;
  double log_share = 0, all = 0;
  for (const std::size_t size : sizes) {
    ++of_one_size[size];
    log_share += std::lgamma(static_cast<double>(size) + 1);
    all += static_cast<double>(size);
  }
  return std::exp(log_share + log_factorials(of_one_size) - std::lgamma(all + 1));
}

}  // namespace drydock::campaign
