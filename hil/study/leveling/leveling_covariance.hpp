#pragma once

#include <array>
#include <vector>

#include "hil/study/leveling/leveling_motion.hpp"

namespace drydock::study {

/// The paper's covariance analysis: what its filter believes of alpha on a known motion, from
/// P0 = 1, with nothing measured wrong.
struct LevelingCovariance {
  std::vector<double> t_s;
  std::array<std::vector<double>, 3> variance;  ///< of x4, x5, x6
};

LevelingCovariance analyse_leveling(const LevelingMotion& motion, bool stationary);

}  // namespace drydock::study
