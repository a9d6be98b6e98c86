#pragma once

#include <string>
#include <vector>

#include "drivers/capture/reader.hpp"

namespace drydock::capture {

/// The pcapng file of SocketCAN packets that Wireshark writes. A block has a type, a length, a body
/// and the length again. A section head gives the byte order. An interface block gives the link
/// type, the name and the resolution of times. An enhanced packet block holds a frame. The reader
/// ignores other blocks and packets of other link types.
class Pcapng final : public Reader {
 public:
  static constexpr std::string_view name = "pcapng";
  static bool recognises(Bytes head);

  Scan scan(Bytes bytes, bool at_end) override;
  Reading read(Bytes unit) override;

  /// What a serial line carried (link type 250, RTAC serial). It points into the unit and into the
  /// reader.
  struct Serial {
    std::optional<std::chrono::nanoseconds> time;  ///< UTC since 1970
    bool sent = false;                             ///< by the computer, to the device
    std::string_view interface;
    Bytes bytes;
  };
  /// Empty if the unit, which read() has seen, is no such packet or is damaged.
  std::optional<Serial> serial(Bytes unit) const;
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
  Reading read_packet(Bytes body) const;
  struct Packet {
    const Interface* interface = nullptr;
    std::optional<std::chrono::nanoseconds> time;
    Bytes bytes;
  };
  std::optional<Packet> packet_of(Bytes body) const;

  bool big_endian_ = false;
  std::vector<Interface> interfaces_;
  std::size_t to_skip_ = 0;
};

}  // namespace drydock::capture
