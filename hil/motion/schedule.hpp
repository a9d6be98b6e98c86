#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "hil/motion/vehicle/actuators.hpp"

namespace drydock::motion {

/// The command from a time until the next entry.
struct ScheduleEntry {
  double t = 0;
  double rudder_rad = 0, stern_rad = 0, bow_rad = 0;
  double propeller_radps = 0;
};

using Schedule = std::vector<ScheduleEntry>;  ///< ordered by time; the first is at 0

/// `FILE:LINE: what is wrong`.
struct BadSchedule : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// CSV with the header `t,rudder,stern,bow,rpm`: s, deg, deg, deg, revolutions per minute. `file`
/// is the name of the text in errors. Throws BadSchedule.
Schedule parse_schedule(std::string_view text, const std::string& file);

/// The command at time `t`. `advance_m` is the propeller's advance per radian.
Command command_at(const Schedule& schedule, double t, double advance_m);

}  // namespace drydock::motion
