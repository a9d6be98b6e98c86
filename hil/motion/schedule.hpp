#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "hil/motion/vehicle/actuators.hpp"

namespace drydock::motion {

/// What is commanded from a time on, until the next entry.
struct ScheduleEntry {
  double t = 0;
  double rudder_rad = 0, stern_rad = 0, bow_rad = 0;
  double propeller_radps = 0;
};

using Schedule = std::vector<ScheduleEntry>;  ///< in order of time, the first at 0

/// `FILE:LINE: what is wrong`.
struct BadSchedule : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// CSV with the header `t,rudder,stern,bow,rpm`: s, deg, deg, deg, revolutions a minute. `file`
/// names the text in errors. Throws BadSchedule.
Schedule parse_schedule(std::string_view text, const std::string& file);

/// The command that holds at `t`; the propeller drives `advance_m` a radian.
Command command_at(const Schedule& schedule, double t, double advance_m);

}  // namespace drydock::motion
