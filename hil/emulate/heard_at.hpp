#pragma once

#include <vector>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/line_rate.hpp"

namespace drydock::emulate {

/// What a receiver at one baud rate reads from a message sent at another. The receiver samples
/// every bit in the middle of its own bit time; both have the same bits of a byte. A character
/// without a valid stop bit is read as 0, and parity is not checked: the default of Linux
/// (termios(3): IGNPAR, PARMRK and INPCK off).
std::vector<std::uint8_t> heard_at(wire::Bytes message, double sent_baud,
                                   wire::LineRate heard_rate);

}  // namespace drydock::emulate
