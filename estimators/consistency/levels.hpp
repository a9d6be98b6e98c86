#pragma once

#include <array>
#include <span>

#include "estimators/consistency/moment.hpp"
#include "estimators/consistency/test.hpp"

namespace drydock::consistency {

/// Specific force against gravity and the change of velocity, for each inertial unit.
class Levels {
 public:
  explicit Levels(Tracks& tracks);

  /// `acceleration`: body, m/s2; empty: no device tells it.
  void step(const Moment& moment, const std::optional<Eigen::Vector3d>& acceleration);

  struct Unit {
    std::uint16_t device;
    const Freeze* freeze;
    std::array<Test, 3> tests;
    double over_s = 0;  ///< since a fault that turned the level is over
  };
  std::span<const Unit> units() const { return units_; }

 private:
  void step(Unit& unit, InertialUnit& inertial, const Moment& moment,
            const Eigen::Vector3d& acceleration, double sigma);

  Tracks& tracks_;
  std::vector<Unit> units_;
  Eigen::Vector3d usual_acceleration_ = Eigen::Vector3d::Zero();
};

}  // namespace drydock::consistency
