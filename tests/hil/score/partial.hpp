#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "estimators/frame/geodetic.hpp"
#include "hil/score/align.hpp"
#include "hil/score/errors.hpp"
#include "hil/score/read_estimates.hpp"

/// A truth in closed form, for estimates that give a part of a state.
namespace drydock::score::partial_test {

using Eigen::Vector3d;

inline constexpr double degree = std::numbers::pi / 180;
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline const frame::Position origin{60 * degree, 5 * degree, -20};
/// The bow is east, rolled and pitched; the way is 2 m/s east, 20 m deep.
inline const Vector3d true_angles = Vector3d{5, -3, 90} * degree;

inline Track truth() {
  Track track;
  for (int t = 0; t <= 20; ++t)
    track.push_back({.at = measurement::stamp_from_ns(t * 1'000'000'000LL),
                     .position_ned = {0, 2. * t, 0},
                     .angles = true_angles,
                     .velocity = {0, 2, 0}});
  return track;
}

inline Errors errors_against_truth(const Estimates& estimates,
                                   Alignment alignment = Alignment::none) {
  auto pairs = pairs_of(estimates.track, truth(), std::chrono::seconds{2});
  EXPECT_EQ(align(pairs.all, alignment), "");
  return errors_of(pairs.all, std::chrono::seconds{1});
}

}  // namespace drydock::score::partial_test
