#include "drivers/wire/j1939/aceinna_setup.hpp"

#include <algorithm>
#include <initializer_list>

#include "drivers/wire/bytes.hpp"

namespace drydock::wire::aceinna {

namespace {

constexpr std::uint8_t priority = 6;

CanFrame frame_of(std::uint32_t pgn, std::uint8_t source, std::initializer_list<unsigned> data) {
  CanFrame frame = j1939::blank_frame({priority, pgn, j1939::global_address, source});
  frame.size = 0;
  for (const unsigned byte : data) frame.data[frame.size++] = static_cast<std::uint8_t>(byte);
  return frame;
}

template <class Layout>
CanFrame frame_of(std::uint32_t pgn, const Flags<Layout>& m, unsigned size) {
  CanFrame frame = frame_of(pgn, m.source, {});
  frame.size = static_cast<std::uint8_t>(size);
  std::fill_n(frame.data.begin(), size, std::uint8_t{0});
  store_le<std::uint16_t>(frame.data, 0, m.bits);
  return frame;
}

template <class Layout>
bool read_flags(std::uint8_t source, Bytes p, Flags<Layout>& m) {
  if (p.size() < 2) return false;
  m.source = source;
  m.bits = load_le<std::uint16_t>(p, 0);
  return true;
}

/// Reads the source and the addressed device of a setting with `size` bytes.
template <class Setting>
bool read_addresses(std::uint8_t source, Bytes p, std::size_t size, Setting& m) {
  if (p.size() < size) return false;
  m.source = source;
  m.device = p[0];
  return true;
}

// Each axis has three bits in the code: the sign, then two bits that count from the axis itself.
constexpr unsigned bits_per_axis = 3, axes = 3;

}  // namespace

CanFrame encode(const HardwareBit& m) { return frame_of(hardware_bit_pgn, m, 2); }
CanFrame encode(const SoftwareBit& m) { return frame_of(software_bit_pgn, m, 2); }
CanFrame encode(const SensorStatus& m) { return frame_of(status_pgn, m, 8); }

CanFrame encode(const PacketRate& m) {
  return frame_of(packet_rate_pgn, m.source, {m.device, m.divider});
}

CanFrame encode(const PacketType& m) {
  return frame_of(packet_type_pgn, m.source, {m.device, m.packets});
}

CanFrame encode(const DigitalFilter& m) {
  return frame_of(filter_pgn, m.source, {m.device, m.rate_hz, m.acceleration_hz});
}

CanFrame encode(const Orientation& m) {
  return frame_of(orientation_pgn, m.source, {m.device, m.code & 0xFFu, unsigned{m.code} >> 8});
}

bool read(std::uint8_t source, Bytes p, HardwareBit& m) { return read_flags(source, p, m); }
bool read(std::uint8_t source, Bytes p, SoftwareBit& m) { return read_flags(source, p, m); }
bool read(std::uint8_t source, Bytes p, SensorStatus& m) { return read_flags(source, p, m); }

bool read(std::uint8_t source, Bytes p, PacketRate& m) {
  if (!read_addresses(source, p, 2, m)) return false;
  m.divider = p[1];
  return true;
}

bool read(std::uint8_t source, Bytes p, PacketType& m) {
  if (!read_addresses(source, p, 2, m)) return false;
  m.packets = p[1];
  return true;
}

bool read(std::uint8_t source, Bytes p, DigitalFilter& m) {
  if (!read_addresses(source, p, 3, m)) return false;
  m.rate_hz = p[1];
  m.acceleration_hz = p[2];
  return true;
}

bool read(std::uint8_t source, Bytes p, Orientation& m) {
  if (!read_addresses(source, p, 3, m)) return false;
  m.code = load_le<std::uint16_t>(p, 1);
  return true;
}

bool Axes::right_handed() const {
  const auto [x, y, z] = output;
  if (x.index == y.index || y.index == z.index || x.index == z.index) return false;
  const bool even = (x.index + 1) % axes == y.index;  // otherwise two axes are exchanged
  return even != ((x.negative != y.negative) != z.negative);
}

std::uint16_t Axes::code() const {
  unsigned code = 0;
  for (unsigned i = 0; i < axes; ++i) {
    const unsigned turned = (output[i].index + axes - i) % axes;
    code |= (unsigned{output[i].negative} | turned << 1) << bits_per_axis * i;
  }
  return static_cast<std::uint16_t>(code);
}

std::optional<Axes> Axes::of_code(std::uint16_t code) {
  if (code >> bits_per_axis * axes != 0) return std::nullopt;
  Axes found;
  for (unsigned i = 0; i < axes; ++i) {
    const unsigned bits = code >> bits_per_axis * i & 7u;
    if (bits >> 1 >= axes) return std::nullopt;
    found.output[i] = {static_cast<std::uint8_t>(((bits >> 1) + i) % axes), (bits & 1u) != 0};
  }
  if (!found.right_handed()) return std::nullopt;
  return found;
}

std::optional<Axes> Axes::of_text(std::string_view text) {
  if (text.size() != 2 * axes) return std::nullopt;
  Axes found;
  for (unsigned i = 0; i < axes; ++i) {
    const char sign = text[2 * i], letter = text[2 * i + 1];
    if ((sign != '+' && sign != '-') || letter < 'X' || letter > 'Z') return std::nullopt;
    found.output[i] = {static_cast<std::uint8_t>(letter - 'X'), sign == '-'};
  }
  if (!found.right_handed()) return std::nullopt;
  return found;
}

}  // namespace drydock::wire::aceinna
