#pragma once

#include <string>
#include <vector>

#include "drivers/capture/reader.hpp"

namespace drydock::capture {

/// The pcapng file of SocketCAN packets that Wireshark writes: blocks of type, length, body and
/// length again. A section head tells the byte order, interface blocks the link type, the name and
/// the resolution of times, enhanced packet blocks hold the frames. Packets of other link types and
/// other blocks are passed over.
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
    std::uint8_t resolution = 6;  ///< if_tsresol: 10^-n s, with the top bit set 2^-n s
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
