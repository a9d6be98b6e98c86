#pragma once

#include <complex>

#include "drivers/measurement/stamp.hpp"

namespace drydock::pipeline {

/// How a vehicle turned between two speeds, told by headings. Velocities are complex numbers: north
/// or ahead, plus i times east or to starboard. Allocates nothing, throws nothing.
class TurnedWay {
 public:
  using Horizontal = std::complex<double>;

  void begin(double heading_rad, measurement::Stamp at);
  /// The heading at a later time; it went there evenly.
  void turn_to(double heading_rad, measurement::Stamp at);

  /// The mean velocity, north and east, of a vehicle whose velocity in its own axes went in a line
  /// from one to the other since the begin. 0 where no time has passed.
  Horizontal mean(Horizontal from_ahead, Horizontal to_ahead) const;
  /// The longest time between two headings.
  double longest_s() const { return longest_s_; }

 private:
  double heading_rad_ = 0, longest_s_ = 0, elapsed_s_ = 0;
  measurement::Stamp at_{};
  Horizontal sum_, moment_;  ///< integrals of the bow's direction, s, and of it times time, s2
};

}  // namespace drydock::pipeline
