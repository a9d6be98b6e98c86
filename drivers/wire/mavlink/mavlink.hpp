#pragma once

#include <optional>
#include <string_view>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/mavlink/mavlink_messages.hpp"
#include "drivers/wire/message_list.hpp"

namespace drydock::wire {

using MavlinkMessages = MessageList<mavlink::Heartbeat, mavlink::Timesync, mavlink::Odometry,
                                    mavlink::VisionPositionDelta>;

/// MAVLink 2: FD, length, two bytes of flags, sequence, system, component, id (24 bits), payload
/// without its last zeros, CRC-16/MCRF4XX of all behind FD and of a byte that the kind of message
/// has, a signature if the flags say so. Frames of MAVLink 1 (FE) are read too. The checksum of
/// a kind that is not in the list cannot be tried, so such frames are passed over as noise.
struct Mavlink {
  static constexpr std::string_view name = "mavlink";
  static constexpr std::size_t max_frame = 10 + 255 + 2 + 13;
  using Message = MavlinkMessages::Variant;

  static Scan scan(Bytes bytes);
  static std::optional<Message> decode(Bytes frame);
};

namespace mavlink {

/// A frame of MAVLink 2 without signature. Returns its size; 0: `out` is too small.
std::size_t encode(const Mavlink::Message& message, std::span<std::uint8_t> out);

}  // namespace mavlink
}  // namespace drydock::wire
