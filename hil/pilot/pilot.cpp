#include "hil/pilot/pilot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/measurement/earlier.hpp"
#include "rig_config/steering.hpp"

namespace drydock::pilot {

Pilot::Pilot(const rig_config::Rig& rig, Stamp start, const OrderPorts::Send& send,
             OrderPorts::Say say)
    : state_(rig),
      place_(rig, start),
      plan_(rig.mission),
      autopilot_(rig.mission.vehicle.value()),
      advance_m_(rig.mission.vehicle->propeller.advance_m),
      ports_(rig, send, say),
      say_(std::move(say)),
      start_(start),
      next_(start) {}

std::optional<Stamp> Pilot::deadline() const {
  return measurement::earlier(ports_.deadline(), std::optional<Stamp>(next_));
}

void Pilot::tick(Stamp now) {
  ports_.tick(now);
  if (now < next_) return;
  steer(now);
  next_ += ((now - next_) / period + 1) * period;
}

void Pilot::steer(Stamp now) {
  auto state = state_.at(now);
  const bool blind = !state && orders_ > 0;  // before the first order sensors may still start
  if (blind && !was_blind_)
    say_(fmt::format("{:.1f} s: the autopilot gives no orders, no {} came for {} s",
                     measurement::seconds(now - start_), state_.missing(now),
                     MeasuredState::oldest.count()));
  was_blind_ = blind;
  if (!state) {
    silences_ += blind ? 1 : 0;
    return;
  }
  place_.place(*state, now);
  if (const auto passed = plan_.pass(*state, memory_.guidance)) tell(*passed, now);
  const double period_s = std::chrono::duration<double>(period).count();
  const auto wanted =
      plan_.at(measurement::seconds(now - start_), *state, memory_.guidance, period_s);
  const auto command = autopilot_.steer(wanted, *state, memory_, period_s);
  ports_.order({command.delta_r, command.delta_s, command.delta_b, command.speed_mps / advance_m_},
               now);
  ++orders_;
}

void Pilot::tell(const motion::Passed& passed, Stamp now) const {
  say_(fmt::format("{:.1f} s: waypoint {} of {} is {}, {:.1f} m off by the autopilot's reckoning{}",
                   measurement::seconds(now - start_), passed.waypoint + 1,
                   plan_.guidance()->waypoints().size(), passed.reached ? "reached" : "missed",
                   passed.off_m,
                   memory_.guidance.over ? "; it was the last, the vehicle goes straight on" : ""));
}

bool is_wanted(const rig_config::Rig& rig) {
  return rig_config::steered_over_wires(rig.mission) && rig_config::has_plan(rig.mission);
}

}  // namespace drydock::pilot
