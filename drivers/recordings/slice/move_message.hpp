#pragma once

#include <span>

#include "drivers/recordings/slice/displacement.hpp"
#include "drivers/wire/nmea0183/nmea0183_sentence.hpp"

namespace drydock::slice {

enum class Fate : std::uint8_t { as_it_is, moved, dropped };

/// Writes a valid sentence at another place into `out` and its length into `size`. The sentence
/// grows by at most 80 characters.
Fate move_sentence(wire::Bytes sentence, Displacement& place, std::span<std::uint8_t> out,
                   std::size_t& size);

/// Does the same for a UBX frame, in place.
Fate move_ubx(std::span<std::uint8_t> frame, Displacement& place);

}  // namespace drydock::slice
