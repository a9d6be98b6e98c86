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

 private:
  struct Interface {
    bool is_can = false;
    std::string name;
    std::uint8_t resolution = 6;  ///< if_tsresol: 10^-n s, or 2^-n s if the top bit is set
  };

  std::uint32_t number(Bytes bytes, std::size_t offset) const;
  std::uint16_t half(Bytes bytes, std::size_t offset) const;
  Reading read_interface(Bytes body);
  Reading read_packet(Bytes body) const;

  bool big_endian_ = false;
  std::vector<Interface> interfaces_;
  std::size_t to_skip_ = 0;
};

}  // namespace drydock::capture
