#include <algorithm>
#include <array>
#include <limits>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/checksum.hpp"
#include "drivers/wire/dvl/wayfinder.hpp"

namespace drydock::wire {
namespace {

constexpr std::size_t header_size = 9, sum_size = 2;
constexpr std::size_t ping_size = wayfinder::ping_packet_size - header_size - sum_size;
constexpr std::uint8_t ping_structure = 0, version_of_layout = 0x10;

void put_number(std::span<std::uint8_t> out, std::size_t offset, std::optional<double> value) {
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  store_le<float>(out, offset, value ? static_cast<float>(*value) : none);
}

void put_four(std::span<std::uint8_t> out, std::size_t offset, const DvlComponents& four) {
  for (std::size_t i = 0; i < four.size(); ++i) put_number(out, offset + 4 * i, four[i]);
}

void put_clock(std::span<std::uint8_t> out, std::chrono::milliseconds since_1970) {
  using namespace std::chrono;
  const sys_time<milliseconds> at{since_1970};
  const auto day = floor<days>(at);
  const year_month_day date{day};
  const hh_mm_ss time{at - day};
  out[0] = static_cast<std::uint8_t>(static_cast<int>(date.year()) - 2000);
  out[1] = static_cast<std::uint8_t>(static_cast<unsigned>(date.month()));
  out[2] = static_cast<std::uint8_t>(static_cast<unsigned>(date.day()));
  out[3] = static_cast<std::uint8_t>(time.hours().count());
  out[4] = static_cast<std::uint8_t>(time.minutes().count());
  out[5] = static_cast<std::uint8_t>(time.seconds().count());
  store_le<std::uint16_t>(out, 6, static_cast<std::uint16_t>(time.subseconds().count()));
}

}  // namespace

std::size_t wayfinder::encode_packet(std::uint8_t id, Bytes payload, std::span<std::uint8_t> out) {
  const std::size_t covered = header_size + payload.size();
  constexpr std::array<std::uint8_t, 3> front{0xAA, 0x10, 0x01};
  std::ranges::copy(front, out.begin());
  store_le<std::uint16_t>(out, 3, static_cast<std::uint16_t>(covered + sum_size));
  out[5] = 2;
  out[6] = id;
  store_le<std::uint16_t>(out, 7, static_cast<std::uint16_t>(4 + payload.size()));
  std::ranges::copy(payload, out.begin() + header_size);
  store_le<std::uint16_t>(out, covered, byte_sum(Bytes{out.data(), covered}));
  return covered + sum_size;
}

std::size_t encode(const WayfinderPing& m, std::span<std::uint8_t> out) {
  std::array<std::uint8_t, ping_size> data{};
  data[0] = ping_structure;
  data[1] = version_of_layout;
  store_le<std::uint32_t>(data, 2, ping_size);
  data[6] = static_cast<std::uint8_t>(m.system_type);
  data[7] = static_cast<std::uint8_t>(m.system_subtype);
  std::ranges::copy(m.firmware, data.begin() + 8);
  if (m.clock) put_clock(std::span{data}.subspan(12), *m.clock);
  data[20] = m.frame ? static_cast<std::uint8_t>(*m.frame) : 0xFF;
  put_four(data, 21, m.velocity_mps);
  put_four(data, 37, m.range_m);
  put_number(data, 53, m.mean_range_m);
  put_number(data, 57, m.sound_speed_mps);
  store_le<std::uint16_t>(data, 61, static_cast<std::uint16_t>(m.status));
  data[63] = static_cast<std::uint8_t>(m.test_count);
  data[64] = static_cast<std::uint8_t>(m.test_code);
  put_number(data, 65, m.input_v);
  put_number(data, 69, m.transmit_v);
  put_number(data, 73, m.current_a);
  store_le<std::uint16_t>(data, ping_size - 2, byte_sum(Bytes{data}.first(ping_size - 2)));
  return wayfinder::encode_packet(wayfinder::data_id, data, out);
}

}  // namespace drydock::wire
