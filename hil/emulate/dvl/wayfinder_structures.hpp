#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "drivers/wire/codec.hpp"
#include "hil/emulate/dvl/wayfinder_dialogue.hpp"

/// What commands of a Wayfinder and its answers carry: id, version, u32 size, fields. The layouts
/// are those of the maker's example programs.
namespace drydock::emulate::wayfinder {

inline constexpr unsigned system_type = 76;

void append_clock(std::vector<std::uint8_t>& out, WayfinderDialogue::Clock clock);
void append_system(std::vector<std::uint8_t>& out);
void append_setup(std::vector<std::uint8_t>& out, const WayfinderSetup& setup);
void append_tests(std::vector<std::uint8_t>& out);  ///< all six passed
void append_features(std::vector<std::uint8_t>& out);

/// Empty: no such structure, or no such time.
std::optional<WayfinderDialogue::Clock> clock_of(wire::Bytes structure);
std::optional<WayfinderSetup> setup_of(wire::Bytes structure);

}  // namespace drydock::emulate::wayfinder
