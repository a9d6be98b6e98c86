#pragma once

#include <array>
#include <vector>

#include "hil/study/leveling/leveling_motion.hpp"

namespace drydock::study {

/// The paper's covariance analysis: the covariance of alpha that its filter computes on a known
/// motion, from P0 = 1, without measurement errors.
struct LevelingCovariance {
  std::vector<double> t_s;
  std::array<std::vector<double>, 3> variance;  ///< x4, x5, x6
};

LevelingCovariance analyse_leveling(const LevelingMotion& motion, bool stationary);

}  // namespace drydock::study
