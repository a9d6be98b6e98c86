#pragma once

#include <span>

#include "estimators/consistency/helm.hpp"
#include "estimators/consistency/moment.hpp"
#include "estimators/consistency/test.hpp"

namespace drydock::consistency {

/// The rudder against the curvature of the way: rate of turn over speed. A hull turns by its speed
/// through the water; an emulated vehicle may do so over ground. The law that fits counts.
class Steering {
 public:
  explicit Steering(const Tracks& tracks);
  /// `speed_mps` over ground; `through_water_mps`: empty if nothing tells how the water moves.
  void step(const Moment& moment, std::optional<double> speed_mps,
            std::optional<double> through_water_mps);

  struct Rudder {
    std::uint16_t device;
    const Freeze* freeze;
    Test test;
    Helm over_ground{}, through_water{};
    double last = 0;  ///< the rudder that the curvature needs
    std::uint64_t serial = 0;

    void interrupt() {
      over_ground.interrupt();
      through_water.interrupt();
    }
  };
  std::span<const Rudder> rudders() const { return rudders_; }

 private:
  static void step(Rudder& rudder, const Moment& moment);

  const Tracks& tracks_;
  std::vector<Rudder> rudders_;
  double ground_mps_ = 0, water_mps_ = 0;  ///< low-passed; 0: not known
};

}  // namespace drydock::consistency
