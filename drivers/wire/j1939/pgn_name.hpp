#pragma once

#include <cstdint>
#include <string_view>

namespace drydock::wire::j1939 {

/// What a parameter group of SAE J1939-21, -71, -73 or -81 is about, in a few words; empty if it is
/// not known here.
std::string_view pgn_name(std::uint32_t pgn);

}  // namespace drydock::wire::j1939
