#pragma once

#include <array>

/// The manoeuvre level of a vehicle, from 1 (straight and steady) to 12: the fuzzy inference of
/// Kim, Lee and Han, "Mixing Algorithm for Attitude Computation of Underwater Vehicle Using Fuzzy
/// Theory" (1996), and the table that can replace it. Equation numbers are those of
/// docs/estimators/mixing.md.
namespace drydock::mixing {

/// Peaks of the five sets VS, S, M, B, VB of an input. Neighbours cross at 1/2. VS is 1 below the
/// first peak, VB is 1 above the last.
using Peaks = std::array<double, 5>;

/// Fig. 5 and 6 of the paper are lost. These peaks give all 36 cells of its Table 3.
struct FuzzySets {
  Peaks attitude_rate{0.003, 0.016, 0.0175, 0.0225, 0.03};  ///< rad/s, of eq. (6)
  Peaks velocity_rate{0.15, 0.25, 0.5, 1.5, 5};             ///< m/s2, of eq. (7)
};

/// The same with the peaks of VS at zero, probably as in the figures of the paper. Even small noise
/// then moves the level away from 1.
inline constexpr FuzzySets pointed_sets{{0, 0.016, 0.0175, 0.0225, 0.03}, {0, 0.25, 0.5, 1.5, 5}};

/// Max-min composition of the 25 rules of Table 1, then the centre of area over the 61 points from
/// -30 to 30.
/// Inputs must not be negative.
double inferred_maneuver(double attitude_rate, double velocity_rate, const FuzzySets& sets);

/// Eq. (9) of inferred_maneuver(): 1 to 12.
int inferred_level(double attitude_rate, double velocity_rate, const FuzzySets& sets);

/// Table 3: the level at the nearest boundary of 25 regions, 0 to 0.05 rad/s by 0 to 5 m/s2. Inputs
/// must not be negative.
int scheduled_level(double attitude_rate, double velocity_rate);

/// Table 3: rows in steps of 0.01 rad/s, columns in steps of 1 m/s2.
extern const std::array<std::array<int, 6>, 6> level_table;

/// K1 and K2 of Fig. 2.
struct Gains {
  double k1, k2;
};

/// Table 2 for a level from 1 to 12, with K2 of level 11 corrected.
Gains gains_of_level(int level);

}  // namespace drydock::mixing
