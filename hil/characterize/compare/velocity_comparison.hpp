#pragma once

#include <array>
#include <optional>

#include "hil/characterize/compare/at_one_place.hpp"
#include "hil/characterize/estimate.hpp"

namespace drydock::characterize {

/// A DVL against GNSS: reading = scale R(angle) there(t - delay) + bias, (7).
struct VelocityComparison {
  std::size_t blocks = 0;
  /// Empty, all three: the speed hardly changed, or nothing told the delay.
  std::optional<Estimate> scale, angle_rad, delay_s;  ///< angle about the DVL's z
  std::array<Estimate, 2> bias;  ///< m/s, x and y; where there is no scale, at the speed there was
  double residual = 0;           ///< m/s, rms of block means, of one axis
};

/// Least squares over means of blocks of 1 s, delay by Gauss-Newton from the best of a coarse
/// search. The DVL, the quieter of both, is the regressor; its noise, told from second differences,
/// is taken out of the normal equations. Empty: fewer than ten blocks.
std::optional<VelocityComparison> compare(const AtOnePlace& velocities);

}  // namespace drydock::characterize
