#include "drivers/capture/packet_lines.hpp"

#include <fmt/format.h>

namespace drydock::capture {

bool PacketLines::recognises(Bytes head) {
  if (Pcapng::recognises(head)) return true;
  const auto link_type = Pcap::link_type_of(head);
  return link_type && is_network_link(*link_type);
}

PacketLines::PacketLines(Bytes head) { begin_file(head); }

void PacketLines::begin_file(Bytes head) {
  if (Pcapng::recognises(head))
    file_.emplace<Pcapng>();
  else
    file_.emplace<Pcap>();
}

Scan PacketLines::scan(Bytes bytes) {
  return std::visit([&](auto& file) { return file.scan(bytes, false); }, file_);
}

std::optional<PacketLines::Piece> PacketLines::read(Bytes unit) {
  std::visit([&](auto& file) { file.read(unit); }, file_);
  if (const auto* file = std::get_if<Pcapng>(&file_))
    for (const auto& name : file->serial_lines()) line_of(name, true);
  const auto packet = std::visit([&](auto& file) { return file.packet(unit); }, file_);
  return packet ? take(*packet) : std::nullopt;
}

std::optional<PacketLines::Piece> PacketLines::take(const CapturedPacket& packet) {
  return packet.link_type == linktype_rtac_serial ? read_serial(packet) : read_network(packet);
}

std::size_t PacketLines::line_of(const std::string& name, bool serial) {
  const auto [known, is_new] = places_.try_emplace(name, lines_.size());
  if (is_new) {
    lines_.push_back({name, serial});
    talks_.emplace_back();
  }
  return known->second;
}

std::optional<PacketLines::Piece> PacketLines::piece(std::size_t line,
                                                     std::optional<std::chrono::nanoseconds> time,
                                                     Bytes bytes) {
  if (bytes.empty()) return {};
  if (time) time = times_.of(lines_[line].name, *time);
  lines_[line].bytes += bytes.size();
  return Piece{time, line, bytes};
}

/// Only what the device said.
std::optional<PacketLines::Piece> PacketLines::read_serial(const CapturedPacket& packet) {
  constexpr std::size_t event_at = 8, header = 12;  // seconds, microseconds, event, lines, footer
  constexpr std::uint8_t received = 2;              // DATA_RX_START
  if (packet.bytes.size() < header || packet.bytes[event_at] != received) return {};
  const auto line = line_of(std::string(packet.interface), true);
  lines_[line].cut += packet.cut;
  return piece(line, packet.time, packet.bytes.subspan(header));
}

PacketLines::Conversation& PacketLines::conversation(const NetworkSegment& segment) {
  const auto [at, is_new] = conversations_.try_emplace({segment.sender, segment.receiver});
  if (is_new) {
    // A sender has a line for each receiver: two connections are two streams.
    const bool known = places_.contains(segment.sender);
    at->second.line =
        line_of(known ? segment.sender + "-" + segment.receiver : segment.sender, false);
    talks_[at->second.line].push_back(&at->second.order);
  }
  return at->second;
}

/// Empty: of another network, or a fragment whose packet is not whole yet.
std::optional<LinkPayload> PacketLines::whole_packet(const CapturedPacket& packet) {
  auto payload = link_payload(packet.link_type, packet.bytes);
  if (!payload) return {};
  if (payload->protocol == protocol_ipv4 && is_ipv4_fragment(payload->bytes)) {
    const auto whole = fragments_.take(payload->bytes, packet.time);
    if (!whole) return {};
    payload->bytes = *whole;
  } else if (const auto sender = sender_of_fragment(*payload); !sender.empty()) {
    ++fragments_v6_[sender];
    return {};
  }
  return payload;
}

std::optional<PacketLines::Piece> PacketLines::read_network(const CapturedPacket& packet) {
  const auto payload = whole_packet(packet);
  const auto segment = payload ? network_segment(*payload) : std::nullopt;
  if (!segment || (segment->payload.empty() && !segment->begins)) return {};
  if (segment->payload.empty() && !conversations_.contains({segment->sender, segment->receiver}))
    return {};
  Conversation& talk = conversation(*segment);
  lines_[talk.line].cut += packet.cut;
  if (!segment->stream) return piece(talk.line, packet.time, segment->payload);
  talk.time = packet.time;
  if (segment->begins) talk.order.begin(segment->sequence);
  talk.order.take(segment->sequence + (segment->begins ? 1 : 0), segment->payload);
  return piece(talk.line, packet.time, talk.order.ready());
}

/// What is missing of one line, or of all.
PacketLines::Missing PacketLines::missing_of(const std::string& line) const {
  Missing missing;
  const auto add = [&](std::size_t place) {
    for (const auto* order : talks_[place]) missing.bytes += order->lost_bytes();
    missing.cut += lines_[place].cut;
  };
  if (line == "*") {
    for (std::size_t place = 0; place < lines_.size(); ++place) add(place);
    missing.fragments = fragments_.left_over(line);
    for (const auto& [sender, count] : fragments_v6_) missing.fragments += count;
    return missing;
  }
  if (const auto known = places_.find(line); known != places_.end()) add(known->second);
  const auto sender = line.substr(0, line.find(line.starts_with('[') ? "]:" : ":"));
  missing.fragments = fragments_.left_over(sender);
  const auto v6 = fragments_v6_.find(sender + "]");
  if (v6 != fragments_v6_.end()) missing.fragments += v6->second;
  return missing;
}

std::string PacketLines::damage(const std::string& line) const {
  const auto [lost, cut, fragments] = missing_of(line);
  std::vector<std::string> parts;
  if (lost > 0) parts.push_back(fmt::format("{} bytes of TCP are not in the file", lost));
  if (cut > 0)
    parts.push_back(
        fmt::format("{} packets are cut short, so their ends are not in the file: "
                    "record whole ones (tcpdump -s 0)",
                    cut));
  if (fragments > 0)
    parts.push_back(fmt::format("{} fragments of IP packets passed over", fragments));
  return fmt::format("{}", fmt::join(parts, "; "));
}

std::optional<PacketLines::Piece> PacketLines::finish() {
  if (!ending_) ending_ = conversations_.begin();
  for (; *ending_ != conversations_.end(); ++*ending_) {
    auto& talk = (*ending_)->second;
    talk.order.finish();
    if (const auto rest = piece(talk.line, talk.time, talk.order.ready())) return rest;
  }
  return {};
}

}  // namespace drydock::capture
