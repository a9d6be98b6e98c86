#include "drivers/capture/formats/pcapng.hpp"

#include <algorithm>

#include "drivers/capture/words.hpp"
#include "drivers/wire/bytes.hpp"

namespace drydock::capture {

namespace {

constexpr std::uint32_t section_block = 0x0A0D0D0A, interface_block = 1, packet_block = 6;
constexpr std::size_t block_head = 8, smallest_block = 12, largest_block = 1u << 18;
constexpr std::size_t most_interfaces = 64;

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
  if (type != packet_block) return Reading::nothing();
  const auto packet = packet_of(body);
  return packet ? can_frame_of(*packet) : Reading::damage();
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

std::optional<CapturedPacket> Pcapng::packet_of(Bytes body) const {
  constexpr std::size_t fixed_part = 20;
  if (body.size() < fixed_part) return {};
  const std::size_t index = number(body, 0), size = number(body, 12);
  if (index >= interfaces_.size() || size > body.size() - fixed_part) return {};
  const std::uint64_t ticks = std::uint64_t{number(body, 4)} << 32 | number(body, 8);
  const Interface& interface = interfaces_[index];
  return CapturedPacket{interface.link_type,
                        interface.name,
                        time_of(ticks, interface.resolution),
                        body.subspan(fixed_part, size),
                        big_endian_,
                        size < number(body, 16)};
}

std::optional<CapturedPacket> Pcapng::packet(Bytes unit) const {
  if (number(unit, 0) != packet_block) return {};
  return packet_of(unit.subspan(block_head, unit.size() - smallest_block));
}

std::vector<std::string> Pcapng::serial_lines() const {
  std::vector<std::string> names;
  for (const auto& interface : interfaces_)
    if (interface.link_type == linktype_rtac_serial) names.push_back(interface.name);
  return names;
}

}  // namespace drydock::capture
