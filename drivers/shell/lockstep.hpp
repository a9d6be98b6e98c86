#pragma once

#include <optional>
#include <vector>

#include "drivers/measurement/stamp.hpp"

/// The lockstep shell: a virtual clock that jumps from event to event. It has no thread and no
/// sleep. The same seed gives the same output, bit for bit.
namespace drydock::shell {

using measurement::Stamp;

/// Acts at its own times: a driver, an emulated device, a line between them.
class Actor {
 public:
  virtual ~Actor() = default;
  virtual std::optional<Stamp> deadline() const = 0;  ///< empty: nothing to do until woken
  virtual void act(Stamp now) = 0;                    ///< called at its deadline

 protected:
  /// Call it if the deadline moves for a reason other than the actor's own act().
  void woken() { asked_ = false; }

 private:
  friend class Lockstep;
  bool asked_ = false;  ///< `due_` equals deadline()
  std::optional<Stamp> due_;
};

class Lockstep {
 public:
  explicit Lockstep(Stamp start) : now_(start) {}

  /// The actor must outlive the shell. Actors due at the same time act in the order of adding.
  void add(Actor& actor) { actors_.push_back(&actor); }

  Stamp now() const { return now_; }

  /// Lets every actor act whose deadline is not later than `end`, then sets the clock to `end`.
  void run_until(Stamp end);

  /// Moves the clock forward without any action. An actor that was due meanwhile acts once, when
  /// time next runs.
  void skip_to(Stamp at) { now_ = at > now_ ? at : now_; }

 private:
  Actor* first_due(Stamp end);

  Stamp now_;
  std::vector<Actor*> actors_;
};

}  // namespace drydock::shell
