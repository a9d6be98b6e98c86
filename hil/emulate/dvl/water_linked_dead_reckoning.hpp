#pragma once

#include "drivers/wire/dvl/water_linked_json_messages.hpp"
#include "hil/motion/truth.hpp"
#include "hil/sensor/mounting.hpp"

namespace drydock::emulate {

/// The way of a DVL since its last reset, in its own axes as they stood then, tilt included. The
/// way is that of the truth; only the stated deviation grows, fast while there is no velocity.
class WaterLinkedDeadReckoning {
 public:
  void reset(const motion::Truth& truth, const sensor::Mounting& mounting);
  void note_velocity(std::optional<double> figure_of_merit_mps, double interval_s);

  /// Empty before the first reset. `turned_rad`: the mounting rotation that the DVL applies.
  std::optional<wire::water_linked_json::Position> at(const motion::Truth& truth,
                                                      const sensor::Mounting& mounting,
                                                      double turned_rad) const;

 private:
  std::optional<motion::Truth> origin_;
  Eigen::Matrix3d origin_to_ned_ = Eigen::Matrix3d::Identity();
  double variance_m2_ = 0, without_velocity_s_ = 0;
};

}  // namespace drydock::emulate
