#pragma once

#include <optional>
#include <vector>

#include "drivers/measurement/stamp.hpp"

/// The lockstep shell: a virtual clock that jumps from event to event. No thread, no sleep, and
/// for one seed the same output to the last bit.
namespace drydock::shell {

using measurement::Stamp;

/// Something that acts at times of its own: a driver, an emulated device, a line between them.
class Actor {
 public:
  virtual ~Actor() = default;
  virtual std::optional<Stamp> deadline() const = 0;  ///< empty: nothing to do until woken
  virtual void act(Stamp now) = 0;                    ///< called at its deadline

 protected:
  /// To be called where the deadline moves for another reason than an act() of its own.
  void woken() { asked_ = false; }

 private:
  friend class Lockstep;
  bool asked_ = false;  ///< `due_` is what deadline() says
  std::optional<Stamp> due_;
};

class Lockstep {
 public:
  explicit Lockstep(Stamp start) : now_(start) {}

  /// The actor must outlive the shell. Actors due at the same time act in the order of adding.
  void add(Actor& actor) { actors_.push_back(&actor); }

  Stamp now() const { return now_; }

  /// Lets every actor act that is due until `end`, then sets the clock to `end`.
  void run_until(Stamp end);

  /// Sets the clock on without letting anyone act: what was due acts once, when time next runs.
  void skip_to(Stamp at) { now_ = at > now_ ? at : now_; }

 private:
  Actor* first_due(Stamp end);

  Stamp now_;
  std::vector<Actor*> actors_;
};

}  // namespace drydock::shell
