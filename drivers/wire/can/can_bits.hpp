#pragma once

#include "drivers/wire/can/can_frame.hpp"

namespace drydock::wire {

/// Bits that a frame takes on the bus with the intermission of 3 bits behind it (ISO 11898-1).
/// Classic frames: exact, with the stuff bits of this frame's content. CAN FD: the most that it can
/// be, counted at one rate. 0 for error frames.
unsigned wire_bits(const CanFrame& frame);

}  // namespace drydock::wire
