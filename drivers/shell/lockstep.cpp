#include "drivers/shell/lockstep.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace drydock::shell {

namespace {
/// A rig does far less at one instant. Beyond this number an actor never moves its deadline.
constexpr int most_acts_at_one_instant = 1'000'000;
}  // namespace

void Lockstep::add(Actor& actor) {
  actor.clock_ = this;
  actor.place_ = actors_.size();
  actors_.push_back(&actor);
  woken_.reserve(actors_.size());
}

void Lockstep::ask(Actor& actor) {
  actor.asked_ = true;
  const auto deadline = actor.deadline();
  std::size_t node = leaves_ + actor.place_;
  const Due due{deadline ? std::max(*deadline, now_) : Stamp::max(), actor.place_};
  if (tree_[node] == due) return;  // most frames of a bus are another driver's
  tree_[node] = due;
  for (node /= 2; node > 0; node /= 2) {
    const Due winner = std::min(tree_[2 * node], tree_[2 * node + 1]);
    if (tree_[node] == winner) return;  // nothing changes above
    tree_[node] = winner;
  }
}

/// The caller of run_until() may have changed the actors, or added some.
void Lockstep::ask_all() {
  leaves_ = std::bit_ceil(std::max<std::size_t>(actors_.size(), 1));
  tree_.assign(2 * leaves_, Due{});
  woken_.clear();
  for (Actor* actor : actors_) ask(*actor);
}

Actor* Lockstep::first_due(Stamp end) {
  for (Actor* actor : woken_) ask(*actor);
  woken_.clear();
  const Due& first = tree_[1];
  return first.at == Stamp::max() || first.at > end ? nullptr : actors_[first.place];
}

void Lockstep::run_until(Stamp end) {
  ask_all();
  int acts_at_this_instant = 0;
  while (Actor* actor = first_due(end)) {
    const Stamp due = tree_[1].at;
    acts_at_this_instant = due > now_ ? 0 : acts_at_this_instant + 1;
    if (acts_at_this_instant > most_acts_at_one_instant) {
      throw std::logic_error("lockstep: an actor stays due at the same instant for ever");
    }
    now_ = due;
    actor->woken();
    actor->act(now_);
  }
  now_ = std::max(now_, end);
}

}  // namespace drydock::shell
