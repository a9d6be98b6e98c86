#pragma once

#include "drivers/capture/formats/captured_packet.hpp"
#include "drivers/capture/reader.hpp"

namespace drydock::capture {

/// libpcap's file of packets (`tcpdump -i can0 -w`), with the CAN frames of it. The file head has
/// 24 bytes; its magic tells the byte order and the unit of time, microseconds or nanoseconds. Each
/// packet has a head of 16 bytes. The file has one interface without a name; the reader calls it
/// can0. Of cooked packets (`tcpdump -i any -w`) those of other networks are passed over.
class Pcap final : public Reader {
 public:
  static constexpr std::string_view name = "pcap";
  static bool recognises(Bytes head);
  /// Empty: the head is of no pcap file.
  static std::optional<std::uint32_t> link_type_of(Bytes head);

  Scan scan(Bytes bytes, bool at_end) override;
  Reading read(Bytes unit) override;
  bool is_inside_block() const override { return to_skip_ > 0; }
  /// The packet of a unit that read() has seen.
  std::optional<CapturedPacket> packet(Bytes unit) const;

 private:
  std::uint32_t number(Bytes bytes, std::size_t offset) const;

  bool head_read_ = false;
  bool big_endian_ = false;
  bool nanoseconds_ = false;
  std::uint32_t link_type_ = 0;
  std::size_t to_skip_ = 0;  ///< bytes left of a packet larger than any
};

}  // namespace drydock::capture
