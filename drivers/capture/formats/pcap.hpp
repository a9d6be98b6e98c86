#pragma once

#include "drivers/capture/reader.hpp"

namespace drydock::capture {

/// libpcap's file of SocketCAN packets (`tcpdump -i can0 -w`): a head of 24 bytes whose magic tells
/// byte order and microseconds or nanoseconds, then packets with a head of 16 each. It has one
/// interface and no name for it: can0.
class Pcap final : public Reader {
 public:
  static constexpr std::string_view name = "pcap";
  static bool recognises(Bytes head);

  Scan scan(Bytes bytes, bool at_end) override;
  Reading read(Bytes unit) override;

 private:
  std::uint32_t number(Bytes bytes, std::size_t offset) const;

  bool head_read_ = false;
  bool big_endian_ = false;
  bool nanoseconds_ = false;
  std::size_t to_skip_ = 0;  ///< of a packet larger than any of CAN
};

}  // namespace drydock::capture
