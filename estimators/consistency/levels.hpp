#pragma once

#include <array>
#include <span>

#include "estimators/consistency/doubts.hpp"
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
    bool at_fault = false;  ///< its own samples show it: they do not pull its level
    double over_s = 0;      ///< since a fault that turned the level is over
    /// The usual difference, m/s2: in the body, and in level axes that keep their heading.
    Eigen::Vector3d in_body = Eigen::Vector3d::Zero();
    Eigen::Vector2d in_level = Eigen::Vector2d::Zero();
    bool learned_fault() const;
    /// The tests learn again: of another level.
    void restart() {
      for (Test& test : tests) test.restart();
    }
  };
  std::span<const Unit> units() const { return units_; }

  /// Test::acquit for all tests that are of no doubtful device that tells motion.
  void acquit(Stamp since, const Doubts& doubts) {
    for (Unit& unit : units_)
      if (!doubts.tells_motion({unit.device}))
        for (Test& test : unit.tests) test.acquit(since);
  }

  /// At the coming time the unit's own samples show that it is at fault.
  void note_fault(std::uint16_t device);
  /// They no longer do: its level begins anew.
  void forget(std::uint16_t device);

 private:
  static double unsettled(Unit& unit, const InertialUnit& inertial,
                          const Eigen::Vector3d& difference, double dt);
  void step(Unit& unit, InertialUnit& inertial, const Moment& moment,
            const Eigen::Vector3d& acceleration, double sigma, bool pulls);

  Tracks& tracks_;
  std::vector<Unit> units_;
  Eigen::Vector3d usual_acceleration_ = Eigen::Vector3d::Zero();
};

}  // namespace drydock::consistency
