#pragma once

#include <array>
#include <span>

#include "estimators/consistency/moment.hpp"
#include "estimators/consistency/test.hpp"

namespace drydock::consistency {

/// Roll, pitch and rate of turn of compasses against the inertial unit.
class Attitudes {
 public:
  explicit Attitudes(const Tracks& tracks);
  void step(const Moment& moment);

  struct Compass {
    std::uint16_t device;
    const Freeze* tilt_freeze;
    const Freeze* turn_freeze;
    std::array<Test, 3> tests;  ///< roll, pitch, rate of turn
    std::uint64_t tilt_serial = 0, turn_serial = 0;
  };
  std::span<const Compass> compasses() const { return compasses_; }

 private:
  void step(Compass& compass, const AttitudeTracks& tracks, const Moment& moment);

  const Tracks& tracks_;
  std::vector<Compass> compasses_;
  double last_turn_ = 0;
};

}  // namespace drydock::consistency
