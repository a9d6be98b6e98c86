#include "drivers/capture/packet_text.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include "drivers/capture/formats/network_segment.hpp"
#include "drivers/capture/hex_dump.hpp"
#include "drivers/wire/bytes.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::capture {

using wire::Bytes;

namespace {

constexpr std::size_t bytes_a_line = 16, largest_packet = 1u << 16;
constexpr std::size_t longest_packet_line = 1024, longest_time = 40;
constexpr std::uint32_t linktype_ethernet = 1, linktype_raw = 101;

struct PlacedBytes {
  std::size_t place = 0;
  std::vector<std::uint8_t> bytes;
};

/// `	0x0010:  0a02 0202 c350  ...`, `0010  0a 02 02 02 c3 50   ...`
std::optional<PlacedBytes> placed_bytes(std::string_view line) {
  constexpr std::size_t shortest_place = 4;
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  if (line.starts_with("0x")) line.remove_prefix(2);
  PlacedBytes placed;
  const auto [end, error] =
      std::from_chars(line.data(), line.data() + line.size(), placed.place, 16);
  const auto digits = static_cast<std::size_t>(end - line.data());
  if (error != std::errc{} || digits < shortest_place) return {};
  line.remove_prefix(digits);
  if (line.starts_with(':')) line.remove_prefix(1);
  if (!line.starts_with(' ') && !line.starts_with('\t')) return {};
  auto bytes = pairs_of_dump(line, true, bytes_a_line);
  if (!bytes || bytes->empty()) return {};
  placed.bytes = std::move(*bytes);
  return placed;
}

bool is_segment(std::uint32_t link_type, Bytes packet) {
  const auto payload = link_payload(link_type, packet);
  return payload && network_segment(*payload).has_value();
}

/// Nothing in the text says it: an IP packet tells its version and its length.
std::uint32_t link_type_of(Bytes packet) {
  constexpr std::size_t shortest_header = 20;
  if (packet.size() < shortest_header) return 0;
  const unsigned version = packet[0] >> 4u;
  const bool is_ip =
      (version == 4 && wire::load_be<std::uint16_t>(packet, 2) <= packet.size()) || version == 6;
  if (is_ip && is_segment(linktype_raw, packet)) return linktype_raw;
  for (const std::uint32_t type : {linktype_ethernet, linktype_linux_sll, linktype_linux_sll2})
    if (is_segment(type, packet)) return type;
  return 0;
}

}  // namespace

bool PacketText::recognises(Bytes head) {
  PacketText text;
  text.feed(head);
  text.finish();
  return text.next().has_value();
}

void PacketText::feed(Bytes block) {
  packets_.erase(packets_.begin(), packets_.begin() + static_cast<std::ptrdiff_t>(at_));
  at_ = 0;
  for (const char letter : wire::as_text(block)) {
    if (letter != '\n') {
      if (line_.size() <= longest_packet_line) line_.push_back(letter);
      continue;
    }
    take_line(line_);
    line_.clear();
  }
}

void PacketText::finish() {
  take_line(line_);
  line_.clear();
  end_packet();
}

void PacketText::take_line(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (auto placed = placed_bytes(line)) {
    if (placed->place == 0) end_packet();
    if (placed->place != packet_.bytes.size() || placed->place >= largest_packet) return;
    packet_.bytes.insert(packet_.bytes.end(), placed->bytes.begin(), placed->bytes.end());
    return;
  }
  end_packet();
  if (const auto time = logger_time(line.substr(0, longest_time), clock_.order())) {
    clock_.take(time);
    packet_.time = clock_.last();
  }
}

/// Without a link type nothing of it can be said.
void PacketText::end_packet() {
  if (packet_.bytes.empty()) return;
  if (link_type_ == 0) link_type_ = link_type_of(packet_.bytes);
  if (link_type_ != 0) packets_.push_back(packet_);
  packet_ = {};
}

std::optional<CapturedPacket> PacketText::next() {
  if (at_ == packets_.size()) return {};
  const Packet& packet = packets_[at_++];
  return CapturedPacket{link_type_, {}, packet.time, packet.bytes};
}

}  // namespace drydock::capture
