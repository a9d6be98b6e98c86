#include "hil/pilot/pilot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/measurement/earlier.hpp"
#include "rig_config/steering.hpp"

namespace drydock::pilot {

Pilot::Pilot(const rig_config::Rig& rig, Stamp start, OrderPorts::Send send, OrderPorts::Say say)
    : state_(rig),
      profile_(rig.mission),
      autopilot_(rig.mission.vehicle.value()),
      advance_m_(rig.mission.vehicle->propeller.advance_m),
      ports_(rig, std::move(send), say),
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
  const auto state = state_.at(now);
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
  const auto plan = profile_.at(measurement::seconds(now - start_));
  const auto command =
      autopilot_.steer(plan, *state, memory_, std::chrono::duration<double>(period).count());
  ports_.order({command.delta_r, command.delta_s, command.delta_b, command.speed_mps / advance_m_},
               now);
  ++orders_;
}

bool is_wanted(const rig_config::Rig& rig) {
  return rig_config::steered_over_wires(rig.mission) && !rig.mission.legs.empty();
}

}  // namespace drydock::pilot
