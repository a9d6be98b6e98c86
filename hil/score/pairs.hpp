#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "hil/score/track.hpp"

namespace drydock::score {

struct Pair {
  State estimate, truth;  ///< of the same time
};

struct Pairs {
  std::vector<Pair> all;
  std::uint64_t without_truth = 0;  ///< estimates before, after, or in a gap of the truth
  std::uint64_t in_gaps = 0;        ///< of those, the ones in a gap
  double widest_gap_s = 0;          ///< of these
  std::uint64_t out_of_order = 0;   ///< estimates that are not later than the one before
};

/// The truth at the time of each estimate, between two of its states that are at most `longest_gap`
/// apart: positions and velocities along a line, attitudes along the shortest turn.
Pairs pairs_of(const Track& estimates, const Track& truth, std::chrono::nanoseconds longest_gap);

}  // namespace drydock::score
