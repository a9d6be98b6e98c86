#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"
#include "hil/sensor/random.hpp"

/// What happens to single messages on a wire. A message of a serial line is its bytes.
namespace drydock::fault {

using Message = std::vector<std::uint8_t>;
using sensor::RandomStream;

void flip_bit(Message& message, RandomStream& random);
void flip_bit(wire::CanFrame& frame, RandomStream& random);  ///< of its data

/// Cuts a random part off the end, at least one byte; of one byte everything.
void truncate(Message& message, RandomStream& random);
void truncate(wire::CanFrame& frame, RandomStream& random);

/// Makes a checksum wrong and leaves what it protects alone: the digits behind the asterisk of a
/// sentence (NMEA 0183 and its like), the last byte of anything else.
void break_checksum(Message& message);

Message garbage(std::size_t bytes, RandomStream& random);
wire::CanFrame garbage_frame(std::size_t bytes, RandomStream& random);  ///< extended, at most 8

/// What a receiver at one baud rate makes of a message sent at another: every bit of 8N1 is sampled
/// in the middle of where the receiver expects it. A character whose stop bit is not there is read
/// as 0, as Linux does by default (termios(3): IGNPAR and PARMRK off).
Message heard_at(wire::Bytes message, double sent_baud, double heard_baud);

}  // namespace drydock::fault
