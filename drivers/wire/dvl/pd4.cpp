#include "drivers/wire/dvl/pd4.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/checksum.hpp"
#include "drivers/wire/quantize.hpp"

namespace drydock::wire {
namespace {

using Out = std::span<std::uint8_t>;

constexpr std::uint8_t sync = 0x7D;
constexpr std::size_t checksum_size = 2;
constexpr std::int16_t bad = -32768;
constexpr std::uint16_t no_heading = 0xFFFF;
/// Low three bits of the system configuration, counted from 1.
constexpr std::array<double, 4> frequency_hz{150e3, 300e3, 600e3, 1200e3};

/// Compares the front of a frame byte by byte, before the length is known.
template <class P>
Scan scan_structure(Bytes bytes) {
  constexpr std::size_t checked = P::max_frame - checksum_size;
  constexpr std::array<std::uint8_t, 4> front{sync, P::structure, checked, 0};
  if (bytes.empty()) return Scan::need_more();
  if (bytes[0] != sync) {
    const void* const start = std::memchr(bytes.data(), sync, bytes.size());
    return Scan::skip(
        start ? static_cast<std::size_t>(static_cast<const std::uint8_t*>(start) - bytes.data())
              : bytes.size());
  }
  const std::size_t known = std::min(bytes.size(), front.size());
  if (!std::equal(front.begin(), front.begin() + known, bytes.begin())) return Scan::skip(1);
  if (bytes.size() < P::max_frame) return Scan::need_more();
  return byte_sum(bytes.first(checked)) == load_le<std::uint16_t>(bytes, checked)
             ? Scan::frame(P::max_frame)
             : Scan::bad_checksum();
}

DvlComponents read_velocity(Bytes frame, std::size_t offset) {
  DvlComponents velocity;
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    const auto mmps = load_le<std::int16_t>(frame, offset + 2 * i);
    if (mmps != bad) velocity[i] = mmps / 1000.0;
  }
  return velocity;
}

void read_configuration(unsigned bits, Pd4Report& m) {
  m.frame = static_cast<DvlFrame>(bits >> 6);
  m.tilts_used = (bits & 0x20) != 0;
  m.three_beam = (bits & 0x10) != 0;
  const std::size_t frequency = bits & 7;
  if (frequency >= 1 && frequency <= frequency_hz.size()) {
    m.frequency_hz = frequency_hz[frequency - 1];
  }
}

std::optional<std::chrono::milliseconds> read_time(Bytes at) {
  if (at[0] > 23 || at[1] > 59 || at[2] > 59 || at[3] > 99) return std::nullopt;
  return std::chrono::hours{at[0]} + std::chrono::minutes{at[1]} + std::chrono::seconds{at[2]} +
         std::chrono::milliseconds{10 * at[3]};
}

/// Angle within +-limit. Empty if the sensor gives no angle.
std::optional<double> tilt(Bytes frame, std::size_t offset, int limit_cdeg) {
  const int raw = load_le<std::int16_t>(frame, offset);
  return std::abs(raw) <= limit_cdeg ? std::optional{radians(raw / 100.0)} : std::nullopt;
}

void read(Bytes frame, Pd4Report& m) {
  read_configuration(frame[4], m);
  m.bottom_velocity_mps = read_velocity(frame, 5);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto range_cm = load_le<std::uint16_t>(frame, 13 + 2 * i);
    if (range_cm != 0) m.bottom_range_m[i] = range_cm / 100.0;
  }
  m.bottom_status = frame[21];
  m.water_velocity_mps = read_velocity(frame, 22);
  m.layer_start_m = load_le<std::uint16_t>(frame, 30) / 10.0;
  m.layer_end_m = load_le<std::uint16_t>(frame, 32) / 10.0;
  m.water_status = frame[34];
  m.first_ping = read_time(frame.subspan(35, 4));
  m.built_in_test = load_le<std::uint16_t>(frame, 39);
  if (const auto speed = load_le<std::uint16_t>(frame, 41)) m.sound_speed_mps = speed;
  if (const auto celsius = load_le<std::int16_t>(frame, 43); celsius != bad) {
    m.temperature_k = celsius / 100.0 + zero_celsius_k;
  }
}

void read(Bytes frame, Pd5Report& m) {
  read(frame, static_cast<Pd4Report&>(m));
  m.salinity_ppt = frame[45];
  m.depth_m = load_le<std::uint16_t>(frame, 46) / 10.0;
  m.pitch_rad = tilt(frame, 48, 9000);
  m.roll_rad = tilt(frame, 50, 18000);
  if (const auto heading = load_le<std::uint16_t>(frame, 52); heading <= 36000) {
    m.heading_rad = radians(heading / 100.0);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    m.bottom_distance_m[i] = load_le<std::int32_t>(frame, 54 + 4 * i) / 10.0;
    m.water_distance_m[i] = load_le<std::int32_t>(frame, 70 + 4 * i) / 10.0;
  }
}

template <class P>
std::optional<typename P::Message> decode_structure(Bytes frame) {
  if (frame.size() < P::max_frame) return std::nullopt;
  typename P::Report m;
  read(frame, m);
  return m;
}

/// A value beyond the range of the wire must not become the mark of a bad value.
std::int16_t signed_field(const std::optional<double>& value, double unit) {
  if (!value) return bad;
  return std::max<std::int16_t>(quantize<std::int16_t>(*value, unit), bad + 1);
}

void write_velocity(Out frame, std::size_t offset, const DvlComponents& velocity) {
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    store_le<std::int16_t>(frame, offset + 2 * i, signed_field(velocity[i], 1e-3));
  }
}

std::uint8_t configuration(const Pd4Report& m) {
  const auto frequency = std::ranges::find(frequency_hz, m.frequency_hz.value_or(0));
  const auto bits = frequency == frequency_hz.end() ? 0 : frequency - frequency_hz.begin() + 1;
  return static_cast<std::uint8_t>(static_cast<unsigned>(m.frame) << 6 |
                                   unsigned{m.tilts_used} << 5 | unsigned{m.three_beam} << 4 |
                                   static_cast<unsigned>(bits));
}

void write(Out frame, const Pd4Report& m) {
  frame[4] = configuration(m);
  write_velocity(frame, 5, m.bottom_velocity_mps);
  for (std::size_t i = 0; i < 4; ++i) {
    store_le<std::uint16_t>(frame, 13 + 2 * i,
                            quantize<std::uint16_t>(m.bottom_range_m[i].value_or(0), 0.01));
  }
  frame[21] = m.bottom_status;
  write_velocity(frame, 22, m.water_velocity_mps);
  store_le<std::uint16_t>(frame, 30, quantize<std::uint16_t>(m.layer_start_m, 0.1));
  store_le<std::uint16_t>(frame, 32, quantize<std::uint16_t>(m.layer_end_m, 0.1));
  frame[34] = m.water_status;
  constexpr auto no_time = std::chrono::hours{255};
  const std::chrono::hh_mm_ss time{m.first_ping.value_or(no_time)};
  frame[35] = static_cast<std::uint8_t>(time.hours().count());
  frame[36] = static_cast<std::uint8_t>(time.minutes().count());
  frame[37] = static_cast<std::uint8_t>(time.seconds().count());
  frame[38] = static_cast<std::uint8_t>(time.subseconds().count() / 10);
  store_le<std::uint16_t>(frame, 39, m.built_in_test);
  store_le<std::uint16_t>(frame, 41, quantize<std::uint16_t>(m.sound_speed_mps.value_or(0), 1));
  const auto celsius =
      m.temperature_k ? std::optional{*m.temperature_k - zero_celsius_k} : std::nullopt;
  store_le<std::int16_t>(frame, 43, signed_field(celsius, 0.01));
}

void write(Out frame, const Pd5Report& m) {
  write(frame, static_cast<const Pd4Report&>(m));
  frame[45] = quantize<std::uint8_t>(m.salinity_ppt, 1);
  store_le<std::uint16_t>(frame, 46, quantize<std::uint16_t>(m.depth_m, 0.1));
  store_le<std::int16_t>(frame, 48, signed_field(degrees(m.pitch_rad), 0.01));
  store_le<std::int16_t>(frame, 50, signed_field(degrees(m.roll_rad), 0.01));
  const auto heading_deg = degrees(m.heading_rad);
  store_le<std::uint16_t>(frame, 52,
                          heading_deg ? quantize<std::uint16_t>(*heading_deg, 0.01) : no_heading);
  for (std::size_t i = 0; i < 4; ++i) {
    store_le<std::int32_t>(frame, 54 + 4 * i, quantize<std::int32_t>(m.bottom_distance_m[i], 0.1));
    store_le<std::int32_t>(frame, 70 + 4 * i, quantize<std::int32_t>(m.water_distance_m[i], 0.1));
  }
}

template <class P>
std::size_t encode_structure(const typename P::Report& m, Out out) {
  constexpr std::size_t checked = P::max_frame - checksum_size;
  if (out.size() < P::max_frame) return 0;
  out[0] = sync;
  out[1] = P::structure;
  store_le<std::uint16_t>(out, 2, checked);
  write(out, m);
  store_le<std::uint16_t>(out, checked, byte_sum(out.first(checked)));
  return P::max_frame;
}

}  // namespace

Scan Pd4::scan(Bytes bytes) { return scan_structure<Pd4>(bytes); }
Scan Pd5::scan(Bytes bytes) { return scan_structure<Pd5>(bytes); }

std::optional<Pd4::Message> Pd4::decode(Bytes frame) { return decode_structure<Pd4>(frame); }
std::optional<Pd5::Message> Pd5::decode(Bytes frame) { return decode_structure<Pd5>(frame); }

std::size_t encode(const Pd4Report& m, Out out) { return encode_structure<Pd4>(m, out); }
std::size_t encode(const Pd5Report& m, Out out) { return encode_structure<Pd5>(m, out); }

}  // namespace drydock::wire
