#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <vector>

#include "drivers/measurement/stamp.hpp"

/// The lockstep shell: a virtual clock that jumps from event to event. It has no thread and no
/// sleep. The same seed gives the same output, bit for bit.
namespace drydock::shell {

using measurement::Stamp;

class Lockstep;

/// Acts at its own times: a driver, an emulated device, a line between them.
class Actor {
 public:
  virtual ~Actor() = default;
  virtual std::optional<Stamp> deadline() const = 0;  ///< empty: nothing to do until woken
  virtual void act(Stamp now) = 0;                    ///< called at its deadline

 protected:
  /// Call it if the deadline moves for a reason other than the actor's own act().
  void woken();

 private:
  friend class Lockstep;
  Lockstep* clock_ = nullptr;  ///< the one that it was added to
  std::size_t place_ = 0;      ///< in the order of adding
  bool asked_ = false;         ///< the clock knows its deadline
};

class Lockstep {
 public:
  explicit Lockstep(Stamp start) : now_(start) {}

  /// The actor must outlive the shell and have no other. Actors due at the same time act in the
  /// order of adding. Not during run_until().
  void add(Actor& actor);

  Stamp now() const { return now_; }

  /// Lets every actor act whose deadline is not later than `end`, then sets the clock to `end`.
  void run_until(Stamp end);

  /// Moves the clock forward without any action. An actor that was due meanwhile acts once, when
  /// time next runs.
  void skip_to(Stamp at) { now_ = at > now_ ? at : now_; }

 private:
  friend class Actor;
  /// When an actor is due, not before the time at which it was asked.
  struct Due {
    Stamp at = Stamp::max();  ///< max: not at all
    std::size_t place = 0;
    auto operator<=>(const Due&) const =
        default;  // NOLINT(modernize-use-nullptr): clang 14 takes it for a 0
  };
  void ask(Actor& actor);
  void ask_all();
  Actor* first_due(Stamp end);

  Stamp now_;
  std::vector<Actor*> actors_;
  std::vector<Actor*> woken_;  ///< to be asked, each once
  /// A knockout tree: the leaves are the actors, every node has the earlier one of its two, and the
  /// winner of all stands at 1. A new deadline replays only its own matches.
  std::vector<Due> tree_;
  std::size_t leaves_ = 1;
};

inline void Actor::woken() {
  if (!asked_) return;
  asked_ = false;
  clock_->woken_.push_back(this);
}

}  // namespace drydock::shell
