#pragma once

#include "drivers/wire/codec.hpp"
#include "drivers/wire/dvl/ad2cp_messages.hpp"
#include "drivers/wire/dvl/ad2cp_track_layout.hpp"

/// Read the data of a record, without its header. False if they are too short for their layout.
namespace drydock::wire::ad2cp {

inline constexpr std::uint8_t signature_bottom_track_id = 0x17;

bool read(Bytes data, Track& m);
bool read(Bytes data, SignatureBottomTrack& m);

/// Year since 1900, month from 0, day, hour, minute, second, u16 of 100 us. Empty: no such time.
std::optional<std::chrono::microseconds> read_clock(Bytes at);

/// Empty if it is not a number.
std::optional<double> read_float(Bytes data, std::size_t offset);

}  // namespace drydock::wire::ad2cp
