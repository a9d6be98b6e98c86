#pragma once

#include "drivers/shell/lockstep.hpp"
#include "hil/pilot/pilot.hpp"

namespace drydock::bench {

/// The pilot in virtual time.
class PilotInStep final : public shell::Actor {
 public:
  /// Throws as pilot::Pilot. `send` gets the frames for each bus.
  PilotInStep(const rig_config::Rig& rig, measurement::Stamp start,
              const pilot::OrderPorts::Send& send, pilot::OrderPorts::Say say)
      : pilot_(rig, start, send, std::move(say)), start_(start) {}

  std::optional<measurement::Stamp> deadline() const override {
    return start_ ? start_ : pilot_.deadline();
  }
  /// The buses open at the first act.
  void act(measurement::Stamp now) override {
    if (start_)
      for (const auto& link : pilot_.ports().links()) pilot_.ports().restart(link, now);
    start_.reset();
    pilot_.tick(now);
  }
  void receive(const measurement::Measurement& m) { pilot_.receive(m); }
  void receive(const std::string& link, const wire::CanFrame& frame, measurement::Stamp now) {
    pilot_.ports().receive(link, frame, now);
    woken();
  }

 private:
  pilot::Pilot pilot_;
  std::optional<measurement::Stamp> start_;  ///< empty once started
};

}  // namespace drydock::bench
