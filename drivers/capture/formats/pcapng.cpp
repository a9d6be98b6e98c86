#include "drivers/capture/formats/pcapng.hpp"

#include <algorithm>

#include "drivers/capture/formats/socketcan_packet.hpp"
#include "drivers/capture/words.hpp"
#include "drivers/wire/bytes.hpp"

namespace drydock::capture {

namespace {

constexpr std::uint32_t section_block = 0x0A0D0D0A, interface_block = 1, packet_block = 6;
constexpr std::size_t block_head = 8, smallest_block = 12, largest_block = 8192;
constexpr std::size_t most_interfaces = 64;
constexpr std::uint16_t linktype_rtac_serial = 250;

/// The byte order of a section. Its magic stands behind type and length. Empty if there is no
/// magic.
std::optional<bool> is_big_endian(Bytes section) {
  constexpr std::uint32_t magic = 0x1A2B3C4D;
  if (section.size() < 12) return std::nullopt;
  if (wire::load_le<std::uint32_t>(section, 8) == magic) return false;
  if (wire::load_be<std::uint32_t>(section, 8) == magic) return true;
  return std::nullopt;
}

/// Time since 1970. Empty after the year 2096: such a time is damaged.
std::optional<std::chrono::nanoseconds> time_of(std::uint64_t ticks, std::uint8_t resolution) {
  const int exponent = resolution & 0x7F;
  if (exponent > 62 || ((resolution & 0x80) == 0 && exponent > 18)) return std::nullopt;
  std::uint64_t per_second = 1;
  for (int i = 0; i < exponent; ++i) per_second *= (resolution & 0x80) != 0 ? 2 : 10;
  const std::uint64_t whole = ticks / per_second, rest = ticks % per_second;
  if (whole >= static_cast<std::uint64_t>(latest_time.count()) / 1'000'000'000) return std::nullopt;
  const double fraction = static_cast<double>(rest) / static_cast<double>(per_second);
  const bool is_exact = (resolution & 0x80) == 0 && exponent <= 9;
  const std::uint64_t ns =
      is_exact ? rest * (1'000'000'000 / per_second) : static_cast<std::uint64_t>(fraction * 1e9);
  return std::chrono::nanoseconds{static_cast<std::int64_t>(whole * 1'000'000'000 + ns)};
}

}  // namespace

bool Pcapng::recognises(Bytes head) {
  return head.size() >= 12 && wire::load_le<std::uint32_t>(head, 0) == section_block &&
         is_big_endian(head).has_value();
}

std::uint32_t Pcapng::number(Bytes bytes, std::size_t offset) const {
  return big_endian_ ? wire::load_be<std::uint32_t>(bytes, offset)
                     : wire::load_le<std::uint32_t>(bytes, offset);
}

std::uint16_t Pcapng::half(Bytes bytes, std::size_t offset) const {
  return big_endian_ ? wire::load_be<std::uint16_t>(bytes, offset)
                     : wire::load_le<std::uint16_t>(bytes, offset);
}

Scan Pcapng::scan(Bytes bytes, bool) {
  if (to_skip_ > 0 && !bytes.empty()) {
    const std::size_t size = std::min(to_skip_, bytes.size());
    to_skip_ -= size;
    return Scan::skip(size);
  }
  if (bytes.size() < smallest_block) return Scan::need_more();
  if (wire::load_le<std::uint32_t>(bytes, 0) == section_block) {
    big_endian_ = is_big_endian(bytes).value_or(big_endian_);
  }
  const std::size_t size = number(bytes, 4);
  if (size < smallest_block || size % 4 != 0) return Scan::bad_checksum();
  if (size > largest_block) {  // secrets, name tables: blocks without frames
    to_skip_ = size - block_head;
    return Scan::skip(block_head);
  }
  return bytes.size() < size ? Scan::need_more() : Scan::frame(size);
}

Reading Pcapng::read(Bytes unit) {
  const std::uint32_t type = number(unit, 0);
  const Bytes body = unit.subspan(block_head, unit.size() - smallest_block);
  if (type == section_block) interfaces_.clear();
  if (type == interface_block) return read_interface(body);
  return type == packet_block ? read_packet(body) : Reading::nothing();
}

Reading Pcapng::read_interface(Bytes body) {
  constexpr std::uint16_t name_option = 2, resolution_option = 9;
  constexpr std::size_t fixed_part = 8, option_head = 4;
  if (body.size() < fixed_part || interfaces_.size() == most_interfaces) return Reading::damage();
  Interface interface { half(body, 0), "can" + std::to_string(interfaces_.size()) };
  for (Bytes rest = body.subspan(fixed_part); rest.size() >= option_head;) {
    const std::uint16_t code = half(rest, 0);
    const std::size_t size = half(rest, 2), padded = option_head + (size + 3) / 4 * 4;
    if (code == 0 || padded > rest.size()) break;
    const Bytes value = rest.subspan(option_head, size);
    if (code == name_option) interface.name.assign(value.begin(), value.end());
    if (code == resolution_option && size == 1) interface.resolution = value[0];
    rest = rest.subspan(padded);
  }
  interfaces_.push_back(std::move(interface));
  return Reading::nothing();
}

std::optional<Pcapng::Packet> Pcapng::packet_of(Bytes body) const {
  constexpr std::size_t fixed_part = 20;
  if (body.size() < fixed_part) return {};
  const std::size_t index = number(body, 0), size = number(body, 12);
  if (index >= interfaces_.size() || size > body.size() - fixed_part) return {};
  const std::uint64_t ticks = std::uint64_t{number(body, 4)} << 32 | number(body, 8);
  const Interface& interface = interfaces_[index];
  return Packet{&interface, time_of(ticks, interface.resolution), body.subspan(fixed_part, size)};
}

Reading Pcapng::read_packet(Bytes body) const {
  const auto packet = packet_of(body);
  if (!packet) return Reading::damage();
  if (packet->interface->link_type != linktype_can_socketcan) return Reading::nothing();
  const auto frame = parse_socketcan_packet(packet->bytes);
  if (!frame) return Reading::damage();
  return {Record{packet->time, packet->interface->name, *frame}, false};
}

std::vector<std::string> Pcapng::serial_lines() const {
  std::vector<std::string> names;
  for (const auto& interface : interfaces_)
    if (interface.link_type == linktype_rtac_serial) names.push_back(interface.name);
  return names;
}

std::optional<Pcapng::Serial> Pcapng::serial(Bytes unit) const {
  constexpr std::size_t event_at = 8, header = 12;  // seconds, microseconds, event, lines, footer
  constexpr std::uint8_t sent = 1, received = 2;    // DATA_TX_START, DATA_RX_START
  if (number(unit, 0) != packet_block) return {};
  const auto packet = packet_of(unit.subspan(block_head, unit.size() - smallest_block));
  if (!packet || packet->interface->link_type != linktype_rtac_serial) return {};
  if (packet->bytes.size() < header) return {};
  const std::uint8_t event = packet->bytes[event_at];
  if (event != sent && event != received) return {};
  return Serial{packet->time, event == sent, packet->interface->name,
                packet->bytes.subspan(header)};
}

}  // namespace drydock::capture
