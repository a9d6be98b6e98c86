#pragma once

#include "drivers/measurement/sound_speed_used.hpp"
#include "hil/report/table.hpp"

namespace drydock::characterize {

/// What a DVL's speed of sound does to its velocities.
report::Table sound_speed_table(const std::string& device,
                                const measurement::SoundSpeedUsed::Means& means);

}  // namespace drydock::characterize
