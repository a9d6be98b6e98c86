#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/mavlink/mavlink_fields.hpp"
#include "drivers/wire/mavlink/mavlink_messages.hpp"
#include "drivers/wire/message_list.hpp"

namespace drydock::wire {

using MavlinkMessages = MessageList<mavlink::Heartbeat, mavlink::Timesync, mavlink::Odometry,
                                    mavlink::VisionPositionDelta, mavlink::SystemTime,
                                    mavlink::GpsRawInt, mavlink::ScaledPressure, mavlink::Attitude,
                                    mavlink::LocalPositionNed, mavlink::GlobalPositionInt,
                                    mavlink::VfrHud, mavlink::DistanceSensor, mavlink::StatusText>;

/// MAVLink 2: FD, length, two bytes of flags, sequence, system, component, id (24 bits), payload
/// without its last zeros, CRC-16/MCRF4XX of all behind FD and of a byte that the kind of message
/// has, a signature if the flags say so. Frames of MAVLink 1 (FE) are read too. Frames of
/// other kinds that mavlink_kinds.hpp names are frames without a message; the checksum of any other
/// kind cannot be tried, so such frames are noise.
struct Mavlink {
  static constexpr std::string_view name = "mavlink";
  static constexpr std::size_t max_frame = 10 + 255 + 2 + 13;
  using Message = MavlinkMessages::Variant;

  static Scan scan(Bytes bytes);
  static std::optional<Message> decode(Bytes frame);
  static std::string frame_name(Bytes frame);  ///< of a whole frame: "MAVLink RAW_IMU"
};

namespace mavlink {

/// A frame of MAVLink 2 without signature. Returns its size; 0: `out` is too small.
std::size_t encode(const Mavlink::Message& message, std::span<std::uint8_t> out);

}  // namespace mavlink
}  // namespace drydock::wire
