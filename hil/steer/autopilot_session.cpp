#include "hil/steer/autopilot_session.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hil/motion/steered/fin_vehicle.hpp"
#include "hil/steer/physics_line.hpp"

namespace drydock::steer {

AutopilotSession::AutopilotSession(motion::SteeredTrajectory& motion,
                                   const rig_config::MissionConfig& mission)
    : motion_(motion),
      actuators_(joints_of(mission)),
      has_fins_(!mission.thruster_vehicle),
      origin_{mission.latitude_rad, mission.longitude_rad, 0} {}

std::string_view AutopilotSession::answer(wire::Bytes packet, Stamp now, Sender from) {
  const auto servo = read_servo_outputs(packet);
  if (!servo) {
    ++counters_.refused;
    return {};
  }
  if (!admits(from, now)) {
    ++counters_.others;
    return {};
  }
  if (last_count_ == servo->count) {
    ++counters_.repeats;
    return last_answer_;
  }
  if (!takes(servo->count)) {
    ++counters_.late;
    return {};
  }
  step(*servo, now);
  last_answer_ = write_physics(motion_.latest(), motion_.motion_s() - run_began_s_, origin_, line_);
  return last_answer_;
}

bool AutopilotSession::admits(Sender from, Stamp now) {
  if (partner_ && from != *partner_) {
    if (now - heard_at_ <= longest_silence) return false;
    begin_run();
  }
  partner_ = from;
  heard_at_ = now;
  return true;
}

/// A datagram that was overtaken has a count a little below the last one. Any other way back, and
/// any jump that no loss explains, is another run of an autopilot. The count may pass its end.
bool AutopilotSession::takes(std::uint32_t count) {
  constexpr std::uint32_t first_counts = 1;
  constexpr std::int32_t most_overtaken = 16, most_lost = 100'000;
  if (last_count_) {
    const auto ahead = static_cast<std::int32_t>(count - *last_count_);
    const bool overtaken = ahead < 0 && ahead >= -most_overtaken;
    if (overtaken && count > first_counts) return false;
    if (ahead > 0 && ahead <= most_lost) {
      counters_.lost += static_cast<std::uint64_t>(ahead - 1);
    } else {
      begin_run();
    }
  }
  last_count_ = count;
  return true;
}

/// Its time begins with it: one that found the time of an earlier run would jump there.
void AutopilotSession::begin_run() {
  if (!last_count_) return;
  ++counters_.restarts;
  last_count_.reset();
  run_began_s_ = motion_.motion_s();
}

void AutopilotSession::step(const ServoOutputs& servo, Stamp now) {
  std::array<double, 32> outputs{};
  for (std::size_t i = 0; i < servo.pulse_us.size(); ++i)
    outputs[i] = normalised(servo.pulse_us[i]);
  order(std::span<const double>(outputs), now);
  const auto timed_out = [this](const Joint&) { ++counters_.timeouts; };
  motion_.step(actuators_.outputs(now, motion_.latest(), timed_out), 1.0 / servo.rate_hz, now);
  ++counters_.steps;
}

/// An output beyond the last thruster moves nothing.
void AutopilotSession::order(std::span<const double> outputs, Stamp now) {
  const auto fins = motion::fin_shares_of(outputs);
  const auto shares = has_fins_ ? std::span<const double>(fins) : outputs;
  const std::size_t joints = std::min(actuators_.joints().size(), shares.size());
  for (std::size_t i = 0; i < joints; ++i) actuators_.order(i, shares[i], now);
}

std::vector<std::string> AutopilotSession::notes() const {
  std::vector<std::string> notes{
      fmt::format("ardupilot: {} steps, {:.3f} s of motion; {} repeats, {} lost, {} late, {} "
                  "refused packets, {} "
                  "restarts",
                  counters_.steps, motion_.motion_s(), counters_.repeats, counters_.lost,
                  counters_.late, counters_.refused, counters_.restarts)};
  if (counters_.others > 0)
    notes.push_back(fmt::format(
        "ardupilot: {} packets of a second autopilot had no answer, because the first still spoke",
        counters_.others));
  if (counters_.timeouts > 0)
    notes.push_back(
        fmt::format("ardupilot: {} times a joint that heard nothing went to its safe state",
                    counters_.timeouts));
  if (motion_.waits() + motion_.jumps() > 0)
    notes.push_back(fmt::format(
        "ardupilot: its clock left real time: the motion stood still {} times and jumped ahead {} "
        "times on the wires",
        motion_.waits(), motion_.jumps()));
  return notes;
}

}  // namespace drydock::steer
