#include "drivers/shell/lockstep.hpp"

#include <algorithm>
#include <stdexcept>

namespace drydock::shell {

namespace {
/// Far more than a rig does at one instant; past it an actor never moves its deadline.
constexpr int most_acts_at_one_instant = 1'000'000;
}  // namespace

void Lockstep::run_until(Stamp end) {
  int acts_at_this_instant = 0;
  for (;;) {
    Actor* first = nullptr;
    Stamp first_due = end;
    for (Actor* actor : actors_) {
      const auto deadline = actor->deadline();
      if (!deadline) continue;
      const Stamp due = std::max(*deadline, now_);
      if (due < first_due || (!first && due == first_due)) {
        first = actor;
        first_due = due;
      }
    }
    if (!first) break;
    acts_at_this_instant = first_due > now_ ? 0 : acts_at_this_instant + 1;
    if (acts_at_this_instant > most_acts_at_one_instant) {
      throw std::logic_error("lockstep: an actor stays due at the same instant for ever");
    }
    now_ = first_due;
    first->act(now_);
  }
  now_ = std::max(now_, end);
}

}  // namespace drydock::shell
