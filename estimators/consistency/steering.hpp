#pragma once

#include <span>

#include "estimators/consistency/helm.hpp"
#include "estimators/consistency/moment.hpp"
#include "estimators/consistency/test.hpp"

namespace drydock::consistency {

/// The rudder against the curvature of the way: rate of turn over speed.
class Steering {
 public:
  explicit Steering(const Tracks& tracks);
  void step(const Moment& moment, std::optional<double> speed_mps);

  struct Rudder {
    std::uint16_t device;
    const Freeze* freeze;
    Test test;
    Helm helm{};
    double last = 0;  ///< the rudder that the curvature needs
    std::uint64_t serial = 0;
  };
  std::span<const Rudder> rudders() const { return rudders_; }

 private:
  static void step(Rudder& rudder, const Moment& moment);

  const Tracks& tracks_;
  std::vector<Rudder> rudders_;
};

}  // namespace drydock::consistency
