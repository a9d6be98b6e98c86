#pragma once

#include <string>
#include <vector>

#include "drivers/capture/formats/captured_packet.hpp"
#include "drivers/capture/reader.hpp"

namespace drydock::capture {

/// The pcapng file of SocketCAN packets that Wireshark writes. A block has a type, a length, a body
/// and the length again. A section head gives the byte order. An interface block gives the link
/// type, the name and the resolution of times. An enhanced packet block holds a packet. Of a
/// network's packets only CAN frames are read; other blocks are ignored.
class Pcapng final : public Reader {
 public:
  static constexpr std::string_view name = "pcapng";
  static bool recognises(Bytes head);

  Scan scan(Bytes bytes, bool at_end) override;
  Reading read(Bytes unit) override;
  bool is_inside_block() const override { return to_skip_ > 0; }

  /// Empty if the unit, which read() has seen, is no packet or is damaged.
  std::optional<CapturedPacket> packet(Bytes unit) const;
  std::vector<std::string> serial_lines() const;  ///< names of those interfaces so far

 private:
  struct Interface {
    std::uint16_t link_type = 0;
    std::string name;
    std::uint8_t resolution = 6;  ///< if_tsresol: 10^-n s, or 2^-n s if the top bit is set
  };

  std::uint32_t number(Bytes bytes, std::size_t offset) const;
  std::uint16_t half(Bytes bytes, std::size_t offset) const;
  Reading read_interface(Bytes body);
  std::optional<CapturedPacket> packet_of(Bytes body) const;

  bool big_endian_ = false;
  std::vector<Interface> interfaces_;
  std::size_t to_skip_ = 0;
};

}  // namespace drydock::capture
