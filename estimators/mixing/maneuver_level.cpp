#include "estimators/mixing/maneuver_level.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::mixing {

const std::array<std::array<int, 6>, 6> level_table{{{1, 5, 7, 8, 9, 10},
                                                     {3, 5, 7, 8, 8, 10},
                                                     {8, 8, 10, 10, 10, 10},
                                                     {12, 11, 12, 11, 11, 12},
                                                     {12, 11, 12, 11, 11, 12},
                                                     {12, 11, 12, 11, 11, 12}}};

namespace {

enum Set : std::size_t { vs, s, m, b, vb };

/// Table 1: rows by the attitude rate, columns by the velocity rate.
constexpr std::array<std::array<Set, 5>, 5> rules{
    {{vs, vs, s, m, b}, {s, s, s, m, b}, {m, m, m, b, b}, {b, b, b, b, b}, {vb, vb, vb, vb, vb}}};

constexpr double row_step = 0.01, column_step = 1;  // Table 3, rad/s and m/s2

/// An input as its two neighbouring sets see it; all others are 0.
struct Fuzzified {
  std::size_t lower;
  std::array<double, 2> membership;  ///< of `lower` and of the set above it
};

Fuzzified fuzzify(double input, const Peaks& peaks) {
  std::size_t lower = 0;
  while (lower < 3 && input > peaks[lower + 1]) ++lower;
  const double way = (input - peaks[lower]) / (peaks[lower + 1] - peaks[lower]);
  const double above = std::clamp(way, 0.0, 1.0);
  return {lower, {1 - above, above}};
}

// The output's sets have their peaks 15 points apart, -30 to 30, and memberships here are counted
// in fifteenths: whole numbers at every point, so that what is symmetrical sums up to exactly 0.
constexpr int points = 15;

/// How far up each set of the output is filled, in fifteenths: the rules of Table 1, min of their
/// two inputs, max over those with the same conclusion. At most four rules are active.
std::array<double, 5> composed(const Fuzzified& rate, const Fuzzified& acceleration) {
  std::array<double, 5> fill{};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      double& conclusion = fill[rules[rate.lower + i][acceleration.lower + j]];
      conclusion =
          std::max(conclusion, points * std::min(rate.membership[i], acceleration.membership[j]));
    }
  }
  return fill;
}

}  // namespace

double inferred_maneuver(double attitude_rate, double velocity_rate, const FuzzySets& sets) {
  const auto fill = composed(fuzzify(attitude_rate, sets.attitude_rate),
                             fuzzify(velocity_rate, sets.velocity_rate));
  // Between two peaks only their two sets are there. The four such spans are summed side by side.
  std::array<double, 4> area{}, moment{};
  for (int k = 0; k < points; ++k) {
    for (std::size_t span = 0; span < 4; ++span) {
      const double falling = std::min(fill[span], static_cast<double>(points - k));
      const double rising = std::min(fill[span + 1], static_cast<double>(k));
      const double membership = std::max(falling, rising);
      area[span] += membership;
      moment[span] += membership * k;
    }
  }
  double all = fill[vb], about_zero = 30 * fill[vb];  // the last point
  for (std::size_t span = 0; span < 4; ++span) {
    all += area[span];
    about_zero += moment[span] + area[span] * (points * static_cast<double>(span) - 30);
  }
  return about_zero / all;
}

int inferred_level(double attitude_rate, double velocity_rate, const FuzzySets& sets) {
  constexpr double rounding = 1e-9;  // a centre of area on a border must not depend on it
  const double maneuver = inferred_maneuver(attitude_rate, velocity_rate, sets);
  return static_cast<int>((maneuver + 30) / 5 + rounding) + 1;
}

int scheduled_level(double attitude_rate, double velocity_rate) {
  const auto nearest = [](double input, double step) {
    return static_cast<std::size_t>(std::lround(std::min(input / step, 5.0)));
  };
  return level_table[nearest(attitude_rate, row_step)][nearest(velocity_rate, column_step)];
}

Gains gains_of_level(int level) {
  static constexpr std::array<double, 12> k1{1e-1, 5e-2, 1e-2, 5e-3, 1e-3, 5e-4,
                                             1e-4, 5e-5, 1e-5, 5e-6, 1e-6, 5e-7};
  const double gain = k1[static_cast<std::size_t>(level - 1)];
  return {gain, gain / 10};
}

}  // namespace drydock::mixing
