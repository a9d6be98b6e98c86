#pragma once

#include "estimators/consistency/constants.hpp"
#include "estimators/consistency/group.hpp"
#include "estimators/consistency/moment.hpp"

namespace drydock::consistency {

/// Changes of the depth: pressure, and the sum of each DVL's velocity down. A constant error of its
/// mounting is taken off. The DVLs share the direction of gravity, so they have one vote.
class Heights {
 public:
  Heights(const Tracks& tracks, const Constants& constants);

  template <class Distrusted>
  void step(const Moment& moment, const Distrusted& distrusted) {
    see(moment);
    group_.settle(moment.at, moment.dt, distrusted);
  }

  /// Test::acquit for all tests that are of no doubtful device that tells motion.
  void acquit(Stamp since, const Doubts& doubts) { group_.acquit(since, doubts); }

  void restart_sums(std::uint16_t device) { group_.restart_sums(device); }
  void note_fault(std::uint16_t device) { group_.note_fault(device); }
  void forget(std::uint16_t device, Stamp since) { group_.forget(device, since); }

  const Group& group() const { return group_; }

 private:
  void see(const Moment& moment);
  void see_dvls(const Moment& moment);

  struct Sum {
    double depth_m = 0, last_mps = 0;
    Stamp last{};
  };

  const Tracks& tracks_;
  const Constants& constants_;
  Group group_;
  std::vector<std::size_t> depths_, dvls_;
  std::vector<Sum> sums_;
};

}  // namespace drydock::consistency
