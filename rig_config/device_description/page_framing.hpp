#pragma once

#include <string>

#include "drivers/wire/described/description.hpp"
#include "drivers/wire/described/frame_plan.hpp"

namespace drydock::rig_config {

/// What holds for all messages of bytes: checksum, stuffing, what ends a frame. A line for each.
std::string protocol_framing(const wire::described::Plan& plan);

/// With what a message of bytes begins, and how long it is. A line for each.
std::string message_framing(const wire::described::Plan& plan,
                            const wire::described::Message& message);

/// Identifier, length, cycle time, counter and checksum of a message in CAN frames. A line for
/// each.
std::string frame_framing(const wire::described::FrameLayout& frame);

/// Bytes as a person reads them: printed ones as they are, others in hexadecimal digits.
std::string readable(std::string_view bytes);

}  // namespace drydock::rig_config
