#include "hil/characterize/compare/comparison.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace drydock::characterize {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Block {
  double t_s = 0, sensor = 0, reference = 0;
  double of_reference = 0;  ///< number of values of the reference
};

double period_of(const Signal& signal) {
  return (signal.t_s.back() - signal.t_s.front()) / static_cast<double>(signal.t_s.size() - 1);
}

/// Sum and number of the values in each block of time. Blocks count from `from`.
std::vector<std::pair<double, double>> sums(const Signal& signal, double from, double length,
                                            std::size_t blocks) {
  std::vector<std::pair<double, double>> all(blocks);
  for (std::size_t i = 0; i < signal.t_s.size(); ++i) {
    const double place = (signal.t_s[i] - from) / length;
    if (place < 0 || place >= static_cast<double>(blocks)) continue;
    auto& [sum, count] = all[static_cast<std::size_t>(place)];
    sum += signal.value[i];
    count += 1;
  }
  return all;
}

std::vector<Block> common_blocks(const Signal& sensor, const Signal& reference, double length) {
  const double from = std::max(sensor.t_s.front(), reference.t_s.front());
  const double to = std::min(sensor.t_s.back(), reference.t_s.back());
  if (!(to > from)) return {};
  const auto places = static_cast<std::size_t>((to - from) / length);
  const auto of_sensor = sums(sensor, from, length, places);
  const auto of_reference = sums(reference, from, length, places);
  // A block that a signal fills only in part would have its centre elsewhere.
  const double full_sensor = 0.75 * length / period_of(sensor);
  const double full_reference = 0.75 * length / period_of(reference);
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < places; ++i) {
    const auto [y, n] = of_sensor[i];
    const auto [x, m] = of_reference[i];
    if (n >= full_sensor && m >= full_reference)
      blocks.push_back({(static_cast<double>(i) + 0.5) * length, y / n, x / m, m});
  }
  return blocks;
}

/// Variance of a signal's noise: a second difference of noise has six times its variance, and one
/// of smooth motion is nearly zero.
double noise_variance(const Signal& signal) {
  double squares = 0;
  const auto& v = signal.value;
  if (v.size() < 3) return 0;
  for (std::size_t i = 2; i < v.size(); ++i) {
    const double d = v[i] - 2 * v[i - 1] + v[i - 2];
    squares += d * d;
  }
  return squares / (6 * static_cast<double>(v.size() - 2));
}

/// The reference's change per second at each block, from the neighbouring blocks.
VectorXd slopes(const std::vector<Block>& blocks) {
  VectorXd slope(static_cast<Index>(blocks.size()));
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const auto& before = blocks[i > 0 ? i - 1 : 0];
    const auto& after = blocks[std::min(i + 1, blocks.size() - 1)];
    slope[static_cast<Index>(i)] = (after.reference - before.reference) / (after.t_s - before.t_s);
  }
  return slope;
}

/// The factor by which serial correlation increases the variance of a mean.
double inflation(const VectorXd& rest) {
  const Index n = rest.size();
  const double lag = rest.head(n - 1).dot(rest.tail(n - 1)) / rest.squaredNorm();
  const double bounded = std::clamp(lag, 0.0, 0.99);
  return (1 + bounded) / (1 - bounded);
}

struct Columns {
  MatrixXd design;
  VectorXd sensor;
  Index scale = -1, delay = -1, drift = -1;  ///< column numbers; the bias is column 0
};

Columns columns_of(const std::vector<Block>& blocks, bool moves, bool with_drift) {
  const auto n = static_cast<Index>(blocks.size());
  Columns columns;
  columns.design = MatrixXd::Ones(n, 1 + (moves ? 2 : 0) + (with_drift ? 1 : 0));
  columns.sensor.resize(n);
  Index next = 1;
  if (moves) {
    columns.scale = next++;
    columns.delay = next++;
    columns.design.col(columns.delay) = slopes(blocks);
  }
  if (with_drift) columns.drift = next++;
  for (Index i = 0; i < n; ++i) {
    const Block& block = blocks[static_cast<std::size_t>(i)];
    columns.sensor[i] = moves ? block.sensor : block.sensor - block.reference;
    if (moves) columns.design(i, columns.scale) = block.reference;
    if (with_drift) columns.design(i, columns.drift) = block.t_s;
  }
  return columns;
}

}  // namespace

std::optional<Comparison> compare(const Signal& sensor, const Signal& reference, bool with_drift) {
  constexpr std::size_t fewest = 10;
  if (sensor.t_s.size() < fewest || reference.t_s.size() < fewest) return std::nullopt;
  const double length = std::max({1.0, 2 * period_of(sensor), 2 * period_of(reference)});
  const auto blocks = common_blocks(sensor, reference, length);
  if (blocks.size() < fewest) return std::nullopt;

  const auto n = static_cast<double>(blocks.size());
  double mean = 0, variance = 0, noise = 0;
  for (const Block& block : blocks) mean += block.reference / n;
  for (const Block& block : blocks) {
    variance += (block.reference - mean) * (block.reference - mean) / n;
    noise += noise_variance(reference) / block.of_reference / n;
  }
  constexpr double motion_over_noise = 25;  // five sigma
  const bool moves = variance > motion_over_noise * noise;
  const Columns columns = columns_of(blocks, moves, with_drift);

  MatrixXd normal = columns.design.transpose() * columns.design;
  if (moves) normal(columns.scale, columns.scale) -= n * noise;
  const MatrixXd inverse = normal.inverse();
  const VectorXd x = inverse * (columns.design.transpose() * columns.sensor);
  const VectorXd rest = columns.sensor - columns.design * x;
  const double freedom = n - static_cast<double>(x.size());
  const double spread = rest.squaredNorm() / freedom * inflation(rest);
  const auto sigma = [&](Index i) { return std::sqrt(spread * inverse(i, i)); };

  Comparison found;
  found.blocks = blocks.size();
  found.residual = std::sqrt(rest.squaredNorm() / n);
  found.bias = normal_estimate(x[0], sigma(0));
  if (moves) {
    const double scale = x[columns.scale];
    found.scale = normal_estimate(scale, sigma(columns.scale));
    found.delay_s =
        normal_estimate(-x[columns.delay] / scale, sigma(columns.delay) / std::abs(scale));
  }
  if (with_drift) found.drift = normal_estimate(x[columns.drift], sigma(columns.drift));
  return found;
}

}  // namespace drydock::characterize
