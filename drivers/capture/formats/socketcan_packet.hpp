#pragma once

#include <optional>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"

namespace drydock::capture {

/// A packet of LINKTYPE_CAN_SOCKETCAN (tcpdump.org/linktypes): identifier with its flags
/// (big-endian, but for cooked packets), length, CAN FD flags, two more bytes, data. Empty for CAN
/// XL and for invalid lengths.
std::optional<wire::CanFrame> parse_socketcan_packet(wire::Bytes packet, bool big_endian);

}  // namespace drydock::capture
