#include "drivers/capture/formats/pcap.hpp"

#include <algorithm>

#include "drivers/wire/bytes.hpp"

namespace drydock::capture {

namespace {

constexpr std::size_t file_head = 24, packet_head = 16, largest_packet = 1u << 18;
constexpr std::uint32_t magic_us = 0xA1B2C3D4, magic_ns = 0xA1B23C4D;

struct Form {
  bool big_endian, nanoseconds;
};

std::optional<Form> form_of(Bytes head) {
  if (head.size() < file_head) return std::nullopt;
  for (const bool big_endian : {false, true}) {
    const auto magic =
        big_endian ? wire::load_be<std::uint32_t>(head, 0) : wire::load_le<std::uint32_t>(head, 0);
    if (magic == magic_us || magic == magic_ns) return Form{big_endian, magic == magic_ns};
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::uint32_t> Pcap::link_type_of(Bytes head) {
  const auto form = form_of(head);
  if (!form) return std::nullopt;
  const auto link_type = form->big_endian ? wire::load_be<std::uint32_t>(head, 20)
                                          : wire::load_le<std::uint32_t>(head, 20);
  return link_type & 0xFFFF;
}

bool Pcap::recognises(Bytes head) {
  const auto link_type = link_type_of(head);
  return link_type && may_hold_can(*link_type);
}

std::uint32_t Pcap::number(Bytes bytes, std::size_t offset) const {
  return big_endian_ ? wire::load_be<std::uint32_t>(bytes, offset)
                     : wire::load_le<std::uint32_t>(bytes, offset);
}

Scan Pcap::scan(Bytes bytes, bool) {
  if (to_skip_ > 0 && !bytes.empty()) {
    const std::size_t size = std::min(to_skip_, bytes.size());
    to_skip_ -= size;
    return Scan::skip(size);
  }
  if (bytes.size() < (head_read_ ? packet_head : file_head)) return Scan::need_more();
  if (!head_read_) return Scan::frame(file_head);
  const std::size_t size = number(bytes, 8);
  if (size > largest_packet) {
    to_skip_ = size;
    return Scan::frame(packet_head);
  }
  return bytes.size() < packet_head + size ? Scan::need_more() : Scan::frame(packet_head + size);
}

Reading Pcap::read(Bytes unit) {
  if (!head_read_) {
    head_read_ = true;
    const auto form = form_of(unit);
    big_endian_ = form && form->big_endian;
    nanoseconds_ = form && form->nanoseconds;
    link_type_ = link_type_of(unit).value_or(0);
    return form ? Reading::nothing() : Reading::damage();
  }
  const auto found = packet(unit);
  return found ? can_frame_of(*found) : Reading::damage();
}

std::optional<CapturedPacket> Pcap::packet(Bytes unit) const {
  if (unit.size() <= packet_head || unit.size() != packet_head + number(unit, 8)) return {};
  const std::chrono::nanoseconds fraction{std::int64_t{number(unit, 4)} *
                                          (nanoseconds_ ? 1 : 1000)};
  return CapturedPacket{link_type_,
                        "can0",
                        std::chrono::seconds{number(unit, 0)} + fraction,
                        unit.subspan(packet_head),
                        big_endian_,
                        number(unit, 8) < number(unit, 12)};
}

}  // namespace drydock::capture
