#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/capture/formats/captured_packet.hpp"
#include "drivers/capture/stamp_clock.hpp"

namespace drydock::capture {

/// Packets of a network as tcpdump (-x, -X, -xx, -XX) and tshark (-x) print them: lines of bytes
/// with places from 0, and tcpdump's line with the time above. Feed the blocks in order.
class PacketText {
 public:
  /// True if one of the first packets is one of UDP or TCP.
  static bool recognises(wire::Bytes head);

  void feed(wire::Bytes block);
  void finish();  ///< no more blocks follow
  /// The next packet of what was fed; valid until the next call of any of these.
  std::optional<CapturedPacket> next();
  const StampClock& clock() const { return clock_; }  ///< of the packets so far

 private:
  struct Packet {
    std::optional<std::chrono::nanoseconds> time;
    std::vector<std::uint8_t> bytes;
  };
  void take_line(std::string_view line);
  void end_packet();

  std::string line_;
  Packet packet_;  ///< that is being read
  std::vector<Packet> packets_;
  std::size_t at_ = 0;           ///< of packets_
  std::uint32_t link_type_ = 0;  ///< the first packet that can be read tells it; 0: none did
  StampClock clock_;
};

}  // namespace drydock::capture
