#pragma once

#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/device/fixed_text.hpp"
#include "drivers/wire/dvl/water_linked_messages.hpp"

/// What the dialogues of both protocols of a Water Linked DVL have in common.
namespace drydock::device {

/// The DVL gets a command up to three times. One that stays silent is asked again later.
namespace water_linked_patience {
constexpr std::chrono::seconds answer_within{1}, start_again_after{30};
constexpr int most_tries = 3;
}  // namespace water_linked_patience

/// The command's values. The text of the range mode is that of `wanted`.
wire::water_linked::Configuration to_set(const WaterLinkedSettings& wanted);

/// True if the rig file leaves all as it is.
bool nothing_to_set(const WaterLinkedSettings& wanted);

struct WaterLinkedAgreement {
  bool velocities = true;  ///< the DVL uses the rig file's speed of sound and turns by its angle
  bool settings = true;    ///< it has all values that the rig file names
};

/// Each value that differs is reported.
WaterLinkedAgreement compare(const WaterLinkedSettings& wanted,
                             const wire::water_linked::Configuration& read, Output& out);

/// The refusal of a DVL that says that it has taken `command`, in words.
Reason keeps_other_values(std::string_view command);

}  // namespace drydock::device
