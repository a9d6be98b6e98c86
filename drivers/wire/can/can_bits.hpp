#pragma once

#include "drivers/wire/can/can_frame.hpp"

namespace drydock::wire {

/// Bits of a frame on the bus, including the intermission of 3 bits behind it (ISO 11898-1).
/// Classic frames: exact, with the stuff bits of this frame's content. CAN FD: the maximum, counted
/// at one rate. 0 for error frames.
unsigned wire_bits(const CanFrame& frame);

/// Those of wire_bits() that a CAN FD frame sends at the rate of its data phase; 0 without a faster
/// one.
unsigned data_phase_bits(const CanFrame& frame);

/// The bits of wire_bits() as if the frame were a classic one, whatever it is. An emulated bus
/// paces every frame so.
unsigned classic_bits(const CanFrame& frame);

}  // namespace drydock::wire
