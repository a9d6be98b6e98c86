#pragma once

#include <numbers>

#include "estimators/consistency/group.hpp"
#include "estimators/consistency/moment.hpp"

namespace drydock::consistency {

/// Changes of the heading: integrated rate of turn, compasses, the DVL's own heading, and the
/// course of GNSS less the drift angle of the DVL.
class Headings {
 public:
  explicit Headings(const Tracks& tracks);

  template <class Distrusted>
  void step(const Moment& moment, const Distrusted& distrusted) {
    if (is_upright(moment))
      see(moment);
    else
      group_.restart();
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
  void see_courses(const Moment& moment);

  const Tracks& tracks_;
  Group group_{2 * std::numbers::pi};
  std::vector<std::size_t> units_, dvls_, compasses_, receivers_;
};

}  // namespace drydock::consistency
