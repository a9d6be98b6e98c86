#pragma once

#include <array>
#include <optional>

#include "hil/characterize/compare/at_one_place.hpp"
#include "hil/characterize/estimate.hpp"

namespace drydock::characterize {

/// A DVL compared with GNSS: reading = scale R(angle) there(t - delay) + bias, (7).
struct VelocityComparison {
  std::size_t blocks = 0;
  /// All three are empty if the speed hardly changed, or if the delay could not be found.
  std::optional<Estimate> scale, angle_rad, delay_s;  ///< angle about the DVL's z
  std::array<Estimate, 2> bias;  ///< m/s, x and y; without a scale, the bias at the speed that
                                 ///< there was
  double residual = 0;           ///< m/s, rms over the means of blocks, one axis
};

/// Least squares over the means of blocks of 1 s. The delay comes from Gauss-Newton steps after a
/// coarse search. The DVL has less noise and is the regressor; its noise is estimated from second
/// differences and removed from the normal equations. Empty if there are fewer than ten blocks.
std::optional<VelocityComparison> compare(const AtOnePlace& velocities);

}  // namespace drydock::characterize
