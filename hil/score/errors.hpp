#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hil/score/pairs.hpp"

namespace drydock::score {

/// Root mean square, mean and largest length of errors.
struct Lengths {
  double rms = 0, mean = 0, max = 0;
};

/// What a track of estimates is worth. Empty: the estimates do not give it.
struct Errors {
  std::uint64_t pairs = 0;
  Lengths ate_m;  ///< absolute trajectory error: length of the position's error
  double horizontal_rms_m = 0, vertical_rms_m = 0, end_m = 0;
  std::optional<Lengths> attitude_deg;  ///< angle of the turn between both attitudes
  std::uint64_t covariances = 0;        ///< pairs with one
  std::uint64_t nees_pairs = 0;         ///< those whose covariance can be inverted
  std::optional<double> nees;           ///< of the position, per axis; 1 is consistent
  std::uint64_t rpe_pairs = 0;
  std::optional<Lengths> rpe_m;  ///< relative pose error: of the way made good in the interval
  std::optional<Lengths> rpe_deg;
};

/// Two poses whose distance in time is off by more than this share of the interval are no pair of a
/// relative error: an error over 10 s says nothing about 1 s. evo has the same share.
inline constexpr double rpe_tolerance = 0.1;

/// `interval`: of the relative pose error. With attitudes the way is in the axes of its beginning.
Errors errors_of(const std::vector<Pair>& pairs, std::chrono::nanoseconds interval);

}  // namespace drydock::score
