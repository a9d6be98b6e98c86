#pragma once

#include <string_view>

#include "hil/study/velocity/velocity_mission.hpp"

/// Files of rig_config that are compiled into the program.
namespace drydock::study {

std::string_view velocity_mission_text();
std::string_view velocity_vehicle_text(Hull hull);

}  // namespace drydock::study
