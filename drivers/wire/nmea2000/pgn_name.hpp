#pragma once

#include <cstdint>
#include <string_view>

namespace drydock::wire::nmea2000 {

/// What a PGN is about, in a word or two; empty if it is not known here. Of PGNs that Drydock reads
/// the message's own `type` says it.
std::string_view pgn_name(std::uint32_t pgn);

}  // namespace drydock::wire::nmea2000
