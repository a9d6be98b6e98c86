#pragma once

#include <cmath>

/// What the filters need of a number besides arithmetic, for one double. lanes.hpp has the same for
/// several runs side by side, so that one text of a filter serves both.
namespace drydock::lanes {

using std::abs;
using std::cos;
using std::sin;
using std::sqrt;

/// `yes` where the condition holds.
inline double select(bool condition, double yes, double no) { return condition ? yes : no; }

inline bool any(bool condition) { return condition; }

/// How many runs a number holds.
template <class Real>
inline constexpr int width = 1;

/// The value of one run.
inline double lane(double value, int) { return value; }
inline void set_lane(double& value, int, double of_lane) { value = of_lane; }

/// Filters of one run have gates and note their innovations; those of several runs have neither.
template <class Real>
inline constexpr bool alone = width<Real> == 1;

}  // namespace drydock::lanes
