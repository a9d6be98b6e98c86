#include "hil/steer/autopilot_session.hpp"

#include <fmt/format.h>

#include "hil/steer/physics_line.hpp"

namespace drydock::steer {

AutopilotSession::AutopilotSession(motion::SteeredTrajectory& motion,
                                   const rig_config::MissionConfig& mission)
    : motion_(motion), origin_{mission.latitude_rad, mission.longitude_rad, 0} {}

std::string_view AutopilotSession::answer(wire::Bytes packet, Stamp now) {
  const auto servo = read_servo_outputs(packet);
  if (!servo) {
    ++counters_.refused;
    return {};
  }
  if (last_count_ == servo->count) {
    ++counters_.repeats;
    return last_answer_;
  }
  note_count(servo->count);
  step(*servo, now);
  last_answer_ = write_physics(motion_.latest(), motion_.motion_s(), origin_, line_);
  return last_answer_;
}

void AutopilotSession::note_count(std::uint32_t count) {
  if (last_count_ && count < *last_count_) ++counters_.restarts;
  if (last_count_ && count > *last_count_) counters_.lost += count - *last_count_ - 1;
  last_count_ = count;
}

void AutopilotSession::step(const ServoOutputs& servo, Stamp now) {
  std::array<double, 32> outputs{};
  for (std::size_t i = 0; i < servo.pulse_us.size(); ++i)
    outputs[i] = normalised(servo.pulse_us[i]);
  motion_.step(std::span(outputs).first(servo.pulse_us.size()), 1.0 / servo.rate_hz, now);
  ++counters_.steps;
}

std::vector<std::string> AutopilotSession::notes() const {
  std::vector<std::string> notes{fmt::format(
      "ardupilot: {} steps, {:.3f} s of motion; {} repeats, {} lost, {} refused packets, {} "
      "restarts",
      counters_.steps, motion_.motion_s(), counters_.repeats, counters_.lost, counters_.refused,
      counters_.restarts)};
  if (motion_.waits() + motion_.jumps() > 0)
    notes.push_back(fmt::format(
        "ardupilot: its clock left real time: the motion stood still {} times and jumped ahead {} "
        "times on the wires",
        motion_.waits(), motion_.jumps()));
  return notes;
}

}  // namespace drydock::steer
