#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"
#include "hil/emulate/heard_at.hpp"
#include "hil/sensor/random.hpp"
#include "rig_config/fault.hpp"

/// Damage to single messages on a wire. A message of a serial line is a vector of bytes.
namespace drydock::fault {

using Message = std::vector<std::uint8_t>;
using sensor::RandomStream;

void flip_bit(Message& message, RandomStream& random);
void flip_bit(wire::CanFrame& frame, RandomStream& random);  ///< flips a data bit

/// The headers of UBX and PD0 have so many bytes, with the sync and the length. That of PD4 and PD5
/// has four.
inline constexpr std::size_t header_bytes = 6;
void flip_header_bit(Message& message, RandomStream& random);

/// Cuts a random part off the end, at least one byte.
void truncate(Message& message, RandomStream& random);
void truncate(wire::CanFrame& frame, RandomStream& random);

/// What a word does to a single message. Null: the word is refused on such a wire.
struct Damage {
  rig_config::FaultKind kind;
  void (*to_message)(Message&, RandomStream&);
  void (*to_frame)(wire::CanFrame&, RandomStream&);
};

/// In the order in which they happen to one message.
std::span<const Damage> damages();

/// Makes a checksum wrong and does not change the protected data: it changes the digits after the
/// asterisk of a sentence (NMEA 0183 and similar), or the last byte of any other message.
void break_checksum(Message& message);

Message garbage(std::size_t bytes, RandomStream& random);
wire::CanFrame garbage_frame(std::size_t bytes, RandomStream& random);  ///< extended, at most 8
                                                                        ///< bytes

using emulate::heard_at;

}  // namespace drydock::fault
