#pragma once

#include <cstdint>
#include <string>

namespace drydock::wire::ubx {

/// As u-blox's interface descriptions call it: "NAV-PVT"; of one that they do not name here class
/// and number, "NAV-7F" or "77-01". For people: it allocates.
std::string message_name(std::uint8_t message_class, std::uint8_t id);

}  // namespace drydock::wire::ubx
