#pragma once

#include <cstdint>
#include <optional>

namespace drydock::consistency {

/// A speed that was off by a constant from the start on: no change shows it. Three sensors tell the
/// speed, and two of them agree.
struct FirstOffset {
  enum class Of : std::uint8_t { dvl, receiver, log };
  Of of = Of::dvl;
  double off_mps = 0;  ///< it reads so much too much

  static constexpr double least_mps = 0.25, least_of_log_mps = 0.4;  ///< sound sensors are better
};

/// `dvl_over_receiver`, `dvl_over_log`: by how much the DVL reads more, m/s; that to the log
/// without the current, `sigma` of it. Empty: they agree, the turns do not yet tell the current, or
/// no two agree and nobody can say which one is wrong.
std::optional<FirstOffset> first_offset(double dvl_over_receiver, double dvl_over_log,
                                        double sigma);

}  // namespace drydock::consistency
