#include "drivers/capture/packet_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace drydock::capture {

bool PacketLines::recognises(Bytes head) {
  if (Pcapng::recognises(head)) return true;
  const auto link_type = Pcap::link_type_of(head);
  return link_type && is_network_link(*link_type);
}

PacketLines::PacketLines(Bytes head) {
  if (Pcapng::recognises(head)) file_.emplace<Pcapng>();
}

Scan PacketLines::scan(Bytes bytes) {
  return std::visit([&](auto& file) { return file.scan(bytes, false); }, file_);
}

std::optional<PacketLines::Piece> PacketLines::read(Bytes unit) {
  std::visit([&](auto& file) { file.read(unit); }, file_);
  if (const auto* file = std::get_if<Pcapng>(&file_))
    for (const auto& name : file->serial_lines()) line_of(name, true);
  const auto packet = std::visit([&](auto& file) { return file.packet(unit); }, file_);
  if (!packet) return {};
  return packet->link_type == linktype_rtac_serial ? read_serial(*packet) : read_network(*packet);
}

std::size_t PacketLines::line_of(const std::string& name, bool serial) {
  const auto found = std::ranges::find(lines_, name, &Line::name);
  if (found == lines_.end()) return lines_.push_back({name, serial}), lines_.size() - 1;
  return static_cast<std::size_t>(found - lines_.begin());
}

std::optional<PacketLines::Piece> PacketLines::piece(std::size_t line,
                                                     std::optional<std::chrono::nanoseconds> time,
                                                     Bytes bytes) {
  if (bytes.empty()) return {};
  lines_[line].bytes += bytes.size();
  return Piece{time, line, bytes};
}

/// Only what the device said.
std::optional<PacketLines::Piece> PacketLines::read_serial(const CapturedPacket& packet) {
  constexpr std::size_t event_at = 8, header = 12;  // seconds, microseconds, event, lines, footer
  constexpr std::uint8_t received = 2;              // DATA_RX_START
  if (packet.bytes.size() < header || packet.bytes[event_at] != received) return {};
  return piece(line_of(std::string(packet.interface), true), packet.time,
               packet.bytes.subspan(header));
}

PacketLines::Conversation& PacketLines::conversation(const NetworkSegment& segment) {
  const auto [at, is_new] = conversations_.try_emplace({segment.sender, segment.receiver});
  if (is_new) {
    // A sender has a line for each receiver: two connections are two streams.
    const bool known = std::ranges::find(lines_, segment.sender, &Line::name) != lines_.end();
    at->second.line =
        line_of(known ? segment.sender + "-" + segment.receiver : segment.sender, false);
  }
  return at->second;
}

std::optional<PacketLines::Piece> PacketLines::read_network(const CapturedPacket& packet) {
  const auto payload = link_payload(packet.link_type, packet.bytes);
  if (const auto sender = payload ? sender_of_fragment(*payload) : ""; !sender.empty())
    return ++fragments_[sender], std::nullopt;
  const auto segment = payload ? network_segment(*payload) : std::nullopt;
  if (!segment || (segment->payload.empty() && !segment->begins)) return {};
  if (segment->payload.empty() && !conversations_.contains({segment->sender, segment->receiver}))
    return {};
  Conversation& talk = conversation(*segment);
  if (!segment->stream) return piece(talk.line, packet.time, segment->payload);
  talk.time = packet.time;
  if (segment->begins) talk.order.begin(segment->sequence);
  talk.order.take(segment->sequence + (segment->begins ? 1 : 0), segment->payload);
  return piece(talk.line, packet.time, talk.order.ready());
}

std::string PacketLines::damage(const std::string& line) const {
  std::uint64_t lost = 0;
  for (const auto& [ends, talk] : conversations_)
    if (line == "*" || lines_[talk.line].name == line) lost += talk.order.lost_bytes();
  std::uint64_t fragments = 0;
  for (const auto& [sender, count] : fragments_)
    if (line == "*" || line.starts_with(sender + ":")) fragments += count;
  std::string text;
  if (lost > 0) text = fmt::format("{} bytes of TCP are not in the file", lost);
  if (fragments > 0)
    text += fmt::format("{}{} fragments of IP packets passed over", text.empty() ? "" : "; ",
                        fragments);
  return text;
}

std::optional<PacketLines::Piece> PacketLines::finish() {
  for (auto& [ends, talk] : conversations_) {
    talk.order.finish();
    if (const auto rest = piece(talk.line, talk.time, talk.order.ready())) return rest;
  }
  return {};
}

}  // namespace drydock::capture
