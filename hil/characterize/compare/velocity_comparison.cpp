#include "hil/characterize/compare/velocity_comparison.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace drydock::characterize {
namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Matrix5d = Eigen::Matrix<double, 5, 5>;
using Vector5d = Eigen::Matrix<double, 5, 1>;

constexpr double block_s = 1, delay_step_s = 0.25;
constexpr int delay_steps = 8;  ///< in each direction
constexpr double longest_delay_s = delay_steps * delay_step_s;

struct PairedBlock {
  Vector2d sensor = Vector2d::Zero(), reference = Vector2d::Zero();
  Vector2d slope = Vector2d::Zero();  ///< of the reference minus the turned sensor, per second of
                                      ///< delay
  double fixes = 0;
};

/// The DVL's part of (7), inverted: there = M reading + offset, M = [a -c; c a].
struct Fit {
  Vector5d x = (Vector5d() << 1, 0, 0, 0, 0).finished();  ///< a, c, offset, additional delay
  Matrix5d covariance;
  double squares = std::numeric_limits<double>::infinity();  ///< mean residual square of one axis
  std::vector<Vector2d> rest;

  Matrix2d turn() const { return (Matrix2d() << x[0], -x[1], x[1], x[0]).finished(); }
};

/// Variance of the noise of one axis: a second difference has six times that.
double noise_of_axis(const Track& track) {
  const auto& v = track.values();
  double squares = 0;
  for (std::size_t i = 2; i < v.size(); ++i)
    squares += (v[i] - 2 * v[i - 1] + v[i - 2]).head<2>().squaredNorm() / 2;
  return v.size() < 3 ? 0 : squares / (6 * static_cast<double>(v.size() - 2));
}

std::vector<PairedBlock> blocks_at(const AtOnePlace& velocities, double delay_s,
                                   const Matrix2d& turn) {
  // The probes are so far apart that they share no reading with the middle one, so their noise is
  // independent.
  const double probe_s = 2.5 * velocities.sensor().period_s();
  std::vector<PairedBlock> blocks;
  double place = -1;
  for (std::size_t i = 0; i < velocities.fixes(); ++i) {
    const auto here = velocities.pair(i, delay_s), before = velocities.pair(i, delay_s - probe_s),
               after = velocities.pair(i, delay_s + probe_s);
    if (!here || !before || !after) continue;
    if (const double now = std::floor(here->t_s / block_s); now != place) {
      place = now;
      blocks.emplace_back();
    }
    PairedBlock& block = blocks.back();
    block.sensor += here->sensor;
    block.reference += here->reference;
    block.slope +=
        (after->reference - before->reference - turn * (after->sensor - before->sensor)) /
        (2 * probe_s);
    block.fixes += 1;
  }
  for (PairedBlock& block : blocks) {
    block.sensor /= block.fixes;
    block.reference /= block.fixes;
    block.slope /= block.fixes;
  }
  return blocks;
}

/// `noise`: variance of a block's reading, one axis. Without `delay` the last unknown stays 0.
Fit fit(const std::vector<PairedBlock>& blocks, double noise, bool delay) {
  Matrix5d normal = Matrix5d::Zero();
  Vector5d right = Vector5d::Zero();
  const auto design = [&](const PairedBlock& b) {
    Eigen::Matrix<double, 2, 5> rows;
    rows << b.sensor.x(), -b.sensor.y(), 1, 0, delay ? -b.slope.x() : 0,  //
        b.sensor.y(), b.sensor.x(), 0, 1, delay ? -b.slope.y() : 0;
    return rows;
  };
  for (const PairedBlock& block : blocks) {
    const auto rows = design(block);
    normal += rows.transpose() * rows;
    right += rows.transpose() * block.reference;
  }
  const auto n = static_cast<double>(blocks.size());
  normal(0, 0) -= 2 * n * noise;
  normal(1, 1) -= 2 * n * noise;
  if (!delay) normal(4, 4) = 1;

  Fit found;
  const Matrix5d inverse = normal.inverse();
  found.x = inverse * right;
  double squares = 0;
  Matrix5d scores = Matrix5d::Zero();
  for (const PairedBlock& block : blocks) {
    const auto rows = design(block);
    found.rest.push_back(block.reference - rows * found.x);
    squares += found.rest.back().squaredNorm();
    const Vector5d score = rows.transpose() * found.rest.back();
    scores += score * score.transpose();
  }
  const double freedom = 2 * n - (delay ? 5 : 4);
  found.squares = squares / freedom;
  // The noise may differ along and across the track (H. White, Econometrica 48, 1980).
  found.covariance = 2 * n / freedom * inverse * scores * inverse;
  return found;
}

/// The factor by which serial correlation increases the variance of a mean.
double inflation_of_pairs(const std::vector<Vector2d>& rest) {
  double lag = 0, all = rest.front().squaredNorm();
  for (std::size_t i = 1; i < rest.size(); ++i) {
    lag += rest[i].dot(rest[i - 1]);
    all += rest[i].squaredNorm();
  }
  const double bounded = std::clamp(lag / all, 0.0, 0.99);
  return (1 + bounded) / (1 - bounded);
}

double noise_of_block(const AtOnePlace& velocities, const std::vector<PairedBlock>& blocks) {
  double fixes = 0;
  for (const PairedBlock& block : blocks) fixes += block.fixes / static_cast<double>(blocks.size());
  return noise_of_axis(velocities.sensor()) /
         std::min(fixes, block_s / velocities.sensor().period_s());
}

bool speed_changes(const std::vector<PairedBlock>& blocks, double noise) {
  constexpr double motion_over_noise = 25;  // five sigma
  Vector2d mean = Vector2d::Zero();
  double variance = 0;
  for (const PairedBlock& b : blocks) mean += b.sensor / static_cast<double>(blocks.size());
  for (const PairedBlock& b : blocks)
    variance += (b.sensor - mean).squaredNorm() / static_cast<double>(blocks.size());
  return variance > motion_over_noise * 2 * noise;
}

VelocityComparison bias_alone(const std::vector<PairedBlock>& blocks) {
  Fit differences;
  Vector2d mean = Vector2d::Zero();
  const auto n = static_cast<double>(blocks.size());
  for (const PairedBlock& b : blocks) mean += (b.sensor - b.reference) / n;
  double squares = 0;
  for (const PairedBlock& b : blocks) {
    differences.rest.emplace_back(b.sensor - b.reference - mean);
    squares += differences.rest.back().squaredNorm();
  }
  const double sigma = std::sqrt(squares / (2 * n - 2) * inflation_of_pairs(differences.rest) / n);
  return {blocks.size(),
          {},
          {},
          {},
          {normal_estimate(mean.x(), sigma), normal_estimate(mean.y(), sigma)},
          std::sqrt(squares / (2 * n))};
}

/// Coarse search: the delay for which a fit without a delay has the smallest residual.
double likeliest_delay(const AtOnePlace& velocities) {
  double best = 0, least = std::numeric_limits<double>::infinity();
  for (int step = -delay_steps; step <= delay_steps; ++step) {
    const double delay = step * delay_step_s;
    const auto blocks = blocks_at(velocities, delay, Matrix2d::Identity());
    if (blocks.size() < 10) continue;
    const double left = fit(blocks, noise_of_block(velocities, blocks), false).squares;
    if (left < least) std::tie(best, least) = std::pair(delay, left);
  }
  return best;
}

/// Converts there = M reading + offset back to reading = scale R(angle) there + bias.
VelocityComparison solved(const Fit& fit, double delay_s, std::size_t blocks) {
  const Matrix5d covariance = fit.covariance * inflation_of_pairs(fit.rest);
  const Matrix2d turn = fit.turn();
  const double size = std::hypot(fit.x[0], fit.x[1]);
  const Vector2d along = fit.x.head<2>() / size, across{-along.y(), along.x()};
  const Matrix2d of_turn = covariance.topLeftCorner<2, 2>();
  const Vector2d bias = -turn.inverse() * fit.x.segment<2>(2);
  const Matrix2d of_bias =
      turn.inverse() * covariance.block<2, 2>(2, 2) * turn.inverse().transpose();
  VelocityComparison found;
  found.blocks = blocks;
  found.scale = normal_estimate(1 / size, std::sqrt(along.dot(of_turn * along)) / (size * size));
  found.angle_rad = normal_estimate(-std::atan2(fit.x[1], fit.x[0]),
                                    std::sqrt(across.dot(of_turn * across)) / size);
  found.delay_s = normal_estimate(delay_s, std::sqrt(covariance(4, 4)));
  for (Index axis = 0; axis < 2; ++axis)
    found.bias[static_cast<std::size_t>(axis)] =
        normal_estimate(bias[axis], std::sqrt(of_bias(axis, axis)));
  found.residual = std::sqrt(fit.squares);
  return found;
}

}  // namespace

std::optional<VelocityComparison> compare(const AtOnePlace& velocities) {
  constexpr std::size_t fewest = 10;
  constexpr int steps = 6;
  double delay_s = likeliest_delay(velocities);
  Fit last;
  std::vector<PairedBlock> blocks;
  for (int step = 0; step < steps; ++step) {
    blocks = blocks_at(velocities, delay_s, last.turn());
    if (blocks.size() < fewest) return std::nullopt;
    const double noise = noise_of_block(velocities, blocks);
    if (!speed_changes(blocks, noise)) return bias_alone(blocks);
    last = fit(blocks, noise, true);
    delay_s = std::clamp(delay_s + last.x[4], -longest_delay_s, longest_delay_s);
  }
  return solved(last, delay_s, blocks.size());
}

}  // namespace drydock::characterize
