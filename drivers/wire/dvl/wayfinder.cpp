#include "drivers/wire/dvl/wayfinder.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/checksum.hpp"

namespace drydock::wire {
namespace {

constexpr std::array<std::uint8_t, 3> packet_front{0xAA, 0x10, 0x01};
constexpr std::size_t packet_header = 5, application_header = 4, packet_sum = 2;
constexpr std::size_t smallest_packet = packet_header + application_header + packet_sum;
constexpr std::size_t smallest_ping = 87;

/// Bytes before the next one that may begin a packet.
std::size_t bytes_before_packet(Bytes bytes) {
  const void* const at = std::memchr(bytes.data(), packet_front[0], bytes.size());
  return at ? static_cast<std::size_t>(static_cast<const std::uint8_t*>(at) - bytes.data())
            : bytes.size();
}

/// A value that the DVL does not have is not a number.
std::optional<double> number_at(Bytes payload, std::size_t offset) {
  const auto value = load_le<float>(payload, offset);
  return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

DvlComponents four_at(Bytes payload, std::size_t offset) {
  DvlComponents four;
  for (std::size_t i = 0; i < four.size(); ++i) four[i] = number_at(payload, offset + 4 * i);
  return four;
}

std::optional<std::chrono::milliseconds> clock_at(Bytes at) {
  using namespace std::chrono;
  const year_month_day date{year{2000 + at[0]}, month{at[1]}, day{at[2]}};
  const unsigned ms = load_le<std::uint16_t>(at, 6);
  if (!date.ok() || at[3] > 23 || at[4] > 59 || at[5] > 59 || ms > 999) return std::nullopt;
  return sys_days{date}.time_since_epoch() + hours{at[3]} + minutes{at[4]} +
         std::chrono::seconds{at[5]} + milliseconds{ms};
}

WayfinderPing read_ping(Bytes payload) {
  WayfinderPing m;
  m.version = payload[1];
  m.system_type = payload[6];
  m.system_subtype = payload[7];
  std::copy_n(payload.begin() + 8, 4, m.firmware.begin());
  m.clock = clock_at(payload.subspan(12));
  if (payload[20] <= static_cast<std::uint8_t>(DvlFrame::earth))
    m.frame = static_cast<DvlFrame>(payload[20]);
  m.velocity_mps = four_at(payload, 21);
  m.range_m = four_at(payload, 37);
  m.mean_range_m = number_at(payload, 53);
  m.sound_speed_mps = number_at(payload, 57);
  m.status = load_le<std::uint16_t>(payload, 61);
  m.test_count = payload[63];
  m.test_code = payload[64];
  m.input_v = number_at(payload, 65);
  m.transmit_v = number_at(payload, 69);
  m.current_a = number_at(payload, 73);
  return m;
}

}  // namespace

WayfinderPart wayfinder::part_of(Bytes packet) {
  return {packet[packet_header + 1],
          packet.subspan(packet_header + application_header, packet.size() - smallest_packet)};
}

Scan Wayfinder::scan(Bytes bytes) {
  if (const std::size_t noise = bytes_before_packet(bytes)) return Scan::skip(noise);
  const std::size_t known = std::min(bytes.size(), packet_front.size());
  if (!std::equal(packet_front.begin(), packet_front.begin() + known, bytes.begin()))
    return Scan::skip(1);
  if (bytes.size() < packet_header) return Scan::need_more();
  const std::size_t size = load_le<std::uint16_t>(bytes, 3);
  if (size < smallest_packet || size > max_frame) return Scan::skip(1);
  if (bytes.size() < size) return Scan::need_more(size);
  const std::size_t covered = size - packet_sum;
  return byte_sum(bytes.first(covered)) == load_le<std::uint16_t>(bytes, covered)
             ? Scan::frame(size)
             : Scan::bad_checksum();
}

std::optional<Wayfinder::Message> Wayfinder::decode(Bytes frame) {
  if (frame.size() < smallest_packet) return std::nullopt;
  const auto [id, payload] = wayfinder::part_of(frame);
  if (id == wayfinder::data_id && payload.size() >= smallest_ping) return read_ping(payload);
  if (id == wayfinder::answer_id && payload.size() >= 5)
    return WayfinderAnswer{load_le<std::uint32_t>(payload, 0), payload[4]};
  return WayfinderOther{id, static_cast<unsigned>(payload.size())};
}

}  // namespace drydock::wire
