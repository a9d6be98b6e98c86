#pragma once

#include <chrono>
#include <optional>
#include <string_view>

#include "drivers/capture/record.hpp"
#include "drivers/wire/codec.hpp"

namespace drydock::capture {

/// A packet of a pcap or pcapng file. It points into the file's bytes and into the reader.
struct CapturedPacket {
  std::uint32_t link_type = 0;                   ///< tcpdump.org/linktypes.html
  std::string_view interface;                    ///< of the recording computer
  std::optional<std::chrono::nanoseconds> time;  ///< UTC since 1970
  wire::Bytes bytes;
  bool big_endian = false;  ///< the recording computer is, as the file says
  bool cut = false;         ///< the recording kept only its begin
};

inline constexpr std::uint32_t linktype_rtac_serial = 250, linktype_can_socketcan = 227;

/// True if packets of this link type can be CAN frames.
bool may_hold_can(std::uint32_t link_type);

/// The CAN frame of a packet; nothing for a packet of another network; damage if it is cut short.
Reading can_frame_of(const CapturedPacket& packet);

}  // namespace drydock::capture
