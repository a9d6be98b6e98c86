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

/// Memberships of an input in its two neighbouring sets; all other memberships are 0.
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

// The sets of the output have their peaks 15 points apart, from -30 to 30. Memberships are counted
// in fifteenths here, so they are whole numbers at every point.
constexpr int points = 15;

/// A sum over the points of one flank of a set, as a function of the fill of the set. The function
/// has its bends at whole fifteenths, so linear interpolation between them is exact.
class Filled {
 public:
  /// Sums `weight(k) * min(fill, height(k))` for k = 1 ... 15 points from the peak.
  constexpr Filled(auto height, auto weight) {
    for (int fill = 0; fill <= points; ++fill)
      for (int k = 1; k <= points; ++k)
        at_[static_cast<std::size_t>(fill)] += weight(k) * std::min(fill, height(k));
  }
  double operator()(double fill) const {
    const int whole = std::min(static_cast<int>(fill), points - 1);
    const auto i = static_cast<std::size_t>(whole);
    return at_[i] + (fill - whole) * (at_[i + 1] - at_[i]);
  }

 private:
  std::array<double, points + 1> at_{};
};

constexpr auto one = [](int) { return 1; };
constexpr auto slope = [](int k) { return points - k; };
constexpr Filled flank_area(slope, one);
constexpr Filled flank_moment(slope, [](int k) { return k; });  // about the peak
/// The common area of two neighbours with the same fill.
constexpr Filled common_area([](int k) { return std::min(k, points - k); }, one);

/// The fill of each set of the output, in fifteenths, by the rules of Table 1: the min of the two
/// inputs of a rule, the max over the rules with the same conclusion. At most four rules are
/// active.
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
  double area = 0, moment = 0;  // of all points; the moment is about the middle point
  for (std::size_t set = vs; set <= vb; ++set) {
    const int flanks = set == vs || set == vb ? 1 : 2;
    const double own = fill[set] + flanks * flank_area(fill[set]);
    area += own;
    moment += own * (points * static_cast<double>(set) - 30);
  }
  moment += flank_moment(fill[vs]) - flank_moment(fill[vb]);
  // max(a, b) = a + b - min(a, b). The area of the min has its centre midway between both peaks.
  for (std::size_t set = vs; set < vb; ++set) {
    const double common = common_area(std::min(fill[set], fill[set + 1]));
    area -= common;
    moment -= common * (points * static_cast<double>(set) - 22.5);
  }
  return moment / area;
}

int inferred_level(double attitude_rate, double velocity_rate, const FuzzySets& sets) {
  constexpr double rounding = 1e-9;  // keeps rounding from deciding a centre of area on a border
  const double maneuver = inferred_maneuver(attitude_rate, velocity_rate, sets);
  return static_cast<int>((maneuver + 30) / 5 + rounding) + 1;
}

int scheduled_level(double attitude_rate, double velocity_rate) {
  // Each comparison is independent of the others and of a guess: the next step waits for the level.
  const auto nearest = [](double input, double step) {
    return static_cast<std::size_t>((input >= 0.5 * step) + (input >= 1.5 * step) +
                                    (input >= 2.5 * step) + (input >= 3.5 * step) +
                                    (input >= 4.5 * step));
  };
  return level_table[nearest(attitude_rate, row_step)][nearest(velocity_rate, column_step)];
}

Gains gains_of_level(int level) {
  static constexpr std::array<double, 12> k1{1e-1, 5e-2, 1e-2, 5e-3, 1e-3, 5e-4,
                                             1e-4, 5e-5, 1e-5, 5e-6, 1e-6, 5e-7};
  static constexpr auto k2 = [] {
    auto tenths = k1;
    for (double& gain : tenths) gain /= 10;
    return tenths;
  }();
  const auto row = static_cast<std::size_t>(level - 1);
  return {k1[row], k2[row]};
}

}  // namespace drydock::mixing
