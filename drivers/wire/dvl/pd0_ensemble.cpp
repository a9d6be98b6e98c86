#include "drivers/wire/dvl/pd0_ensemble.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/dvl/pd0_blocks.hpp"
#include "drivers/wire/quantize.hpp"

namespace drydock::wire {
namespace {

using Out = std::span<std::uint8_t>;

constexpr std::size_t fixed_size = 59, variable_size = 65, bottom_size = 81;

template <class Table>
std::optional<unsigned> index_of(const Table& table, double value) {
  const auto at = std::ranges::find_if(
      table, [value](double entry) { return std::abs(entry - value) < 1e-6 * entry; });
  if (at == table.end()) return std::nullopt;
  return static_cast<unsigned>(at - table.begin());
}

/// Numbers outside of the tables become "reserved" (frequency) and "other" (beam angle).
std::uint16_t system_configuration(const Pd0FixedLeader& m) {
  const unsigned frequency = index_of(pd0::frequency_hz, m.frequency_hz.value_or(0)).value_or(7);
  const unsigned angle =
      index_of(pd0::beam_angle_deg, degrees(m.beam_angle_rad).value_or(0)).value_or(3);
  constexpr unsigned transducer_attached = 1u << 6, four_beam_janus = 4u << 12;
  return static_cast<std::uint16_t>(frequency | unsigned{m.convex} << 3 | transducer_attached |
                                    unsigned{m.faces_up} << 7 | angle << 8 | four_beam_janus);
}

void write(Out block, const Pd0FixedLeader& m) {
  store_le<std::uint16_t>(block, 0, pd0::fixed_leader);
  block[2] = m.firmware_version;
  block[3] = m.firmware_revision;
  store_le<std::uint16_t>(block, 4, system_configuration(m));
  block[8] = m.beams;
  block[9] = m.cells;
  store_le<std::uint16_t>(block, 10, m.pings_per_ensemble);
  store_le<std::uint16_t>(block, 12, quantize<std::uint16_t>(m.cell_length_m, 0.01));
  store_le<std::uint16_t>(block, 14, quantize<std::uint16_t>(m.blank_m, 0.01));
  block[25] = static_cast<std::uint8_t>(static_cast<unsigned>(m.frame) << 3 |
                                        unsigned{m.tilts_used} << 2 | unsigned{m.three_beam} << 1);
  store_le<std::int16_t>(block, 26, quantize<std::int16_t>(degrees(m.heading_alignment_rad), 0.01));
  store_le<std::int16_t>(block, 28, quantize<std::int16_t>(degrees(m.heading_bias_rad), 0.01));
  block[30] = m.sensor_source;
  block[31] = m.sensors_available;
  if (m.beam_angle_rad && !index_of(pd0::beam_angle_deg, degrees(*m.beam_angle_rad))) {
    block[58] = quantize<std::uint8_t>(degrees(*m.beam_angle_rad), 1);
  }
}

/// Writes year (of the century), month, day, hour, minute, second, hundredths.
void write_clock(Out at, std::chrono::local_time<std::chrono::milliseconds> clock) {
  using namespace std::chrono;
  const auto midnight = floor<days>(clock);
  const year_month_day date{midnight};
  const hh_mm_ss time{clock - midnight};
  at[0] = static_cast<std::uint8_t>(static_cast<int>(date.year()) % 100);
  at[1] = static_cast<std::uint8_t>(static_cast<unsigned>(date.month()));
  at[2] = static_cast<std::uint8_t>(static_cast<unsigned>(date.day()));
  at[3] = static_cast<std::uint8_t>(time.hours().count());
  at[4] = static_cast<std::uint8_t>(time.minutes().count());
  at[5] = static_cast<std::uint8_t>(time.seconds().count());
  at[6] = static_cast<std::uint8_t>(time.subseconds().count() / 10);
}

void write_tilt(Out block, std::size_t offset, const std::optional<double>& angle_rad) {
  store_le<std::int16_t>(block, offset,
                         angle_rad ? quantize<std::int16_t>(degrees(*angle_rad), 0.01) : pd0::bad);
}

void write(Out block, const Pd0VariableLeader& m) {
  constexpr std::uint16_t no_heading = 0xFFFF;
  store_le<std::uint16_t>(block, 0, pd0::variable_leader);
  store_le<std::uint16_t>(block, 2, static_cast<std::uint16_t>(m.ensemble));
  block[11] = static_cast<std::uint8_t>(m.ensemble >> 16);
  if (m.clock) {
    write_clock(block.subspan(4, 7), *m.clock);
    const std::chrono::year_month_day date{std::chrono::floor<std::chrono::days>(*m.clock)};
    block[57] = static_cast<std::uint8_t>(static_cast<int>(date.year()) / 100);
    write_clock(block.subspan(58, 7), *m.clock);
  }
  store_le<std::uint16_t>(block, 12, m.built_in_test);
  store_le<std::uint16_t>(block, 14, quantize<std::uint16_t>(m.sound_speed_mps.value_or(0), 1));
  store_le<std::uint16_t>(block, 16, quantize<std::uint16_t>(m.depth_m, 0.1));
  const auto heading_deg = degrees(m.heading_rad);
  store_le<std::uint16_t>(block, 18,
                          heading_deg ? quantize<std::uint16_t>(*heading_deg, 0.01) : no_heading);
  write_tilt(block, 20, m.pitch_rad);
  write_tilt(block, 22, m.roll_rad);
  store_le<std::uint16_t>(block, 24, quantize<std::uint16_t>(m.salinity_ppt, 1));
  store_le<std::int16_t>(
      block, 26,
      m.temperature_k ? quantize<std::int16_t>(*m.temperature_k - zero_celsius_k, 0.01) : pd0::bad);
  store_le<std::int32_t>(block, 48, quantize<std::int32_t>(m.pressure_pa.value_or(0), 10));
}

std::int16_t reversed(const std::optional<double>& vehicle_mps) {
  // A velocity beyond the range of the wire must not become the mark of a bad velocity.
  return vehicle_mps ? std::max<std::int16_t>(quantize<std::int16_t>(-*vehicle_mps, 1e-3), -32767)
                     : pd0::bad;
}

void write_water_layer(Out block, const Pd0BottomTrack& m) {
  store_le<std::uint16_t>(block, 46, quantize<std::uint16_t>(m.layer_near_m.value_or(0), 0.1));
  store_le<std::uint16_t>(block, 48, quantize<std::uint16_t>(*m.layer_far_m, 0.1));
  for (std::size_t i = 0; i < 4; ++i) {
    store_le<std::int16_t>(block, 50 + 2 * i, reversed(m.water_velocity_mps[i]));
    block[66 + i] = m.water_percent_good[i];
  }
}

void write(Out block, const Pd0BottomTrack& m) {
  store_le<std::uint16_t>(block, 0, pd0::bottom_track);
  store_le<std::uint16_t>(block, 2, m.pings_per_ensemble);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto range_cm = quantize<std::uint32_t>(m.range_m[i].value_or(0), 0.01);
    store_le<std::uint16_t>(block, 16 + 2 * i, static_cast<std::uint16_t>(range_cm));
    block[77 + i] = static_cast<std::uint8_t>(range_cm >> 16);
    store_le<std::int16_t>(block, 24 + 2 * i, reversed(m.velocity_mps[i]));
    block[32 + i] = m.correlation[i];
    block[36 + i] = m.amplitude[i];
    block[40 + i] = m.percent_good[i];
  }
  if (m.layer_far_m) write_water_layer(block, m);
  store_le<std::uint16_t>(block, 70, quantize<std::uint16_t>(m.max_depth_m.value_or(0), 0.1));
}

}  // namespace

std::optional<std::chrono::microseconds> age_of(const Pd0Navigation& navigation) {
  std::chrono::microseconds sum{0};
  int beams = 0;
  for (const auto& age : navigation.echo_age) {
    if (!age) continue;
    sum += *age;
    ++beams;
  }
  return beams ? std::optional{sum / beams} : std::nullopt;
}

std::size_t encode(const Pd0Ensemble& m, std::span<std::uint8_t> out) {
  const std::size_t types = m.bottom_track ? 3 : 2;
  const std::size_t fixed_at = 6 + 2 * types, variable_at = fixed_at + fixed_size,
                    bottom_at = variable_at + variable_size,
                    checked = bottom_at + (m.bottom_track ? bottom_size : 0);
  if (out.size() < checked + 2) return 0;
  const Out frame = out.first(checked + 2);
  std::ranges::fill(frame, std::uint8_t{0});
  frame[0] = frame[1] = 0x7F;
  store_le<std::uint16_t>(frame, 2, static_cast<std::uint16_t>(checked));
  frame[5] = static_cast<std::uint8_t>(types);
  store_le<std::uint16_t>(frame, 6, static_cast<std::uint16_t>(fixed_at));
  store_le<std::uint16_t>(frame, 8, static_cast<std::uint16_t>(variable_at));
  write(frame.subspan(fixed_at, fixed_size), m.fixed);
  write(frame.subspan(variable_at, variable_size), m.variable);
  if (m.bottom_track) {
    store_le<std::uint16_t>(frame, 10, static_cast<std::uint16_t>(bottom_at));
    write(frame.subspan(bottom_at, bottom_size), *m.bottom_track);
  }
  std::uint16_t sum = 0;
  for (const std::uint8_t byte : frame.first(checked)) sum = static_cast<std::uint16_t>(sum + byte);
  store_le<std::uint16_t>(frame, checked, sum);
  return frame.size();
}

}  // namespace drydock::wire
