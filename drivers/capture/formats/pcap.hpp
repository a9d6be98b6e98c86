#pragma once

#include "drivers/capture/reader.hpp"

namespace drydock::capture {

/// libpcap's file of SocketCAN packets (`tcpdump -i can0 -w`). The file head has 24 bytes; its
/// magic tells the byte order and the unit of time, microseconds or nanoseconds. Each packet has a
/// head of 16 bytes. The file has one interface without a name; the reader calls it can0.
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
  std::size_t to_skip_ = 0;  ///< bytes left of a packet larger than any CAN packet
};

}  // namespace drydock::capture
