#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "hil/score/pairs.hpp"

namespace drydock::score {

/// How the estimates are moved onto the truth before they are compared.
enum class Alignment : std::uint8_t {
  none,   ///< not at all: both have the same origin and north
  start,  ///< shifted, so that the first pair agrees
  yaw,    ///< shifted and turned about the vertical, for the least squares of positions
  rigid   ///< shifted and turned about any axis, likewise (Umeyama 1991, without a scale)
};
inline constexpr std::array alignment_names{"none", "start", "yaw", "rigid"};

/// Moves the estimates, their attitudes, velocities and covariances. What the pairs do not tell is
/// not moved; the answer says so, for a person. Empty: all was.
std::string align(std::vector<Pair>& pairs, Alignment alignment);

}  // namespace drydock::score
