#include "drivers/wire/bytes.hpp"
#include "drivers/wire/dvl/ad2cp_frame.hpp"
#include "drivers/wire/dvl/ad2cp_track_layout.hpp"
#include "drivers/wire/dvl/ad2cp_write.hpp"
#include "drivers/wire/dvl/nortek_ad2cp.hpp"

namespace drydock::wire::ad2cp {
namespace {

using Out = std::span<std::uint8_t>;

/// As a DVL333 sends them with a velocity that it does not have.
constexpr float rubbish_after_trigger_s = 5.0125F, rubbish_after_output_s = 4.37F;
constexpr float rubbish_duration_s = -10;

void write_four(const Four& four, float without, Out to) {
  for (std::size_t i = 0; i < 4; ++i)
    store_le<float>(to, 4 * i, four[i] ? static_cast<float>(*four[i]) : without);
}

void write_estimates(const Estimates& m, const EstimatesAt& at, Out groups) {
  write_four(m.velocity_mps, bad_velocity_mps, groups.subspan(at.velocity));
  write_four(m.figure_of_merit_mps, bad_merit_mps, groups.subspan(at.merit));
  write_four(m.after_trigger_s, rubbish_after_trigger_s, groups.subspan(at.after_trigger));
  write_four(m.after_output_s, rubbish_after_output_s, groups.subspan(at.after_output));
  write_four(m.duration_s, rubbish_duration_s, groups.subspan(at.duration));
}

std::uint32_t valid_bits(const Four& four, unsigned first_bit) {
  std::uint32_t bits = 0;
  for (unsigned i = 0; i < 4; ++i) bits |= std::uint32_t{four[i].has_value()} << (first_bit + i);
  return bits;
}

std::uint32_t valid_bits(const Estimates& m, const EstimatesAt& at) {
  return valid_bits(m.velocity_mps, at.velocity_bit) |
         valid_bits(m.figure_of_merit_mps, at.merit_bit);
}

std::uint32_t status_of(const Track& m) {
  constexpr std::uint32_t validity = (1U << all_valid_bits) - 1;
  return (m.status & ~validity) | valid_bits(m.beams, beams_at) |
         valid_bits(m.distance_m, distance_bit) | valid_bits(m.axes, axes_at);
}

void write_front(const Track& m, Out data) {
  data[0] = static_cast<std::uint8_t>(m.version);
  data[1] = front_size;
  store_le<std::uint32_t>(data, serial_at, m.serial_number);
  if (m.clock) write_clock(*m.clock, data.subspan(clock_at));
  store_le<std::uint16_t>(data, beam_count_at, static_cast<std::uint16_t>(m.number_of_beams));
  store_le<std::uint32_t>(data, error_at, m.error);
  store_le<std::uint32_t>(data, status_at, status_of(m));
  const auto number = [&](std::size_t offset, double value) {
    store_le<float>(data, offset, static_cast<float>(value));
  };
  number(sound_speed_at, m.sound_speed_mps.value_or(0));
  number(celsius_at, m.temperature_k.value_or(zero_celsius_k) - zero_celsius_k);
  number(bar_at, m.pressure_pa.value_or(0) / pa_per_bar);
}

std::size_t write_track(std::uint8_t id, const Track& m, Out out) {
  constexpr std::size_t data_size = front_size + groups_size;
  if (out.size() < short_header + data_size) return 0;
  const Out data = out.subspan(short_header, data_size);
  std::ranges::fill(data, std::uint8_t{0});
  write_front(m, data);
  const Out groups = data.subspan(front_size);
  write_four(m.distance_m, bad_distance_m, groups.subspan(distance_at));
  write_estimates(m.beams, beams_at, groups);
  write_estimates(m.axes, axes_at, groups);
  return close_record(id, dvl_family, data_size, out);
}

}  // namespace

void write_clock(std::chrono::microseconds clock, Out to) {
  using namespace std::chrono;
  const auto day = floor<days>(clock);
  const year_month_day date{sys_days{day}};
  const hh_mm_ss time{clock - day};
  to[0] = static_cast<std::uint8_t>(static_cast<int>(date.year()) - 1900);
  to[1] = static_cast<std::uint8_t>(static_cast<unsigned>(date.month()) - 1);
  to[2] = static_cast<std::uint8_t>(static_cast<unsigned>(date.day()));
  to[3] = static_cast<std::uint8_t>(time.hours().count());
  to[4] = static_cast<std::uint8_t>(time.minutes().count());
  to[5] = static_cast<std::uint8_t>(time.seconds().count());
  store_le<std::uint16_t>(to, 6, static_cast<std::uint16_t>(time.subseconds().count() / 100));
}

std::size_t encode(const BottomTrack& m, Out out) { return write_track(bottom_track_id, m, out); }
std::size_t encode(const WaterTrack& m, Out out) { return write_track(water_track_id, m, out); }

}  // namespace drydock::wire::ad2cp
