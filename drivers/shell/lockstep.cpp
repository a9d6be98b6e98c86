#include "drivers/shell/lockstep.hpp"

#include <algorithm>
#include <stdexcept>

namespace drydock::shell {

namespace {
/// A rig does far less at one instant. Beyond this number an actor never moves its deadline.
constexpr int most_acts_at_one_instant = 1'000'000;
}  // namespace

Actor* Lockstep::first_due(Stamp end) {
  Actor* first = nullptr;
  Stamp earliest = end;
  for (Actor* actor : actors_) {
    if (!actor->asked_) {
      actor->due_ = actor->deadline();
      actor->asked_ = true;
    }
    if (!actor->due_) continue;
    const Stamp due = std::max(*actor->due_, now_);
    if (due < earliest || (!first && due == earliest)) {
      first = actor;
      earliest = due;
    }
  }
  return first;
}

void Lockstep::run_until(Stamp end) {
  for (Actor* actor : actors_) actor->asked_ = false;  // the caller may have changed the actors
  int acts_at_this_instant = 0;
  while (Actor* actor = first_due(end)) {
    acts_at_this_instant = *actor->due_ > now_ ? 0 : acts_at_this_instant + 1;
    if (acts_at_this_instant > most_acts_at_one_instant) {
      throw std::logic_error("lockstep: an actor stays due at the same instant for ever");
    }
    now_ = std::max(*actor->due_, now_);
    actor->asked_ = false;
    actor->act(now_);
  }
  now_ = std::max(now_, end);
}

}  // namespace drydock::shell
