#pragma once

#include <optional>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"

namespace drydock::capture {

constexpr std::uint32_t linktype_can_socketcan = 227;

/// A packet of LINKTYPE_CAN_SOCKETCAN (tcpdump.org/linktypes): identifier with its flags (always
/// big-endian), length, CAN FD flags, two more bytes, data. Empty for CAN XL and for invalid
/// lengths.
std::optional<wire::CanFrame> parse_socketcan_packet(wire::Bytes packet);

}  // namespace drydock::capture
