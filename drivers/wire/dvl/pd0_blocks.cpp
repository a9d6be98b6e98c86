#include "drivers/wire/dvl/pd0_blocks.hpp"

#include <cstdlib>
#include <limits>

#include "drivers/wire/bytes.hpp"

namespace drydock::wire {
namespace {

constexpr bool bit(unsigned word, unsigned number) { return (word >> number & 1u) != 0; }

double centidegrees(Bytes block, std::size_t offset) {
  return radians(load_le<std::int16_t>(block, offset) / 100.0);
}

/// Angle within +-limit. Empty if the sensor gives no angle.
std::optional<double> tilt(Bytes block, std::size_t offset, int limit_cdeg) {
  const int raw = load_le<std::int16_t>(block, offset);
  return std::abs(raw) <= limit_cdeg ? std::optional{radians(raw / 100.0)} : std::nullopt;
}

void read_system_configuration(unsigned word, Pd0FixedLeader& m) {
  const std::size_t frequency = word & 7, angle = word >> 8 & 3;
  m.frequency_hz.reset();
  m.beam_angle_rad.reset();
  if (frequency < pd0::frequency_hz.size()) m.frequency_hz = pd0::frequency_hz[frequency];
  if (angle < pd0::beam_angle_deg.size()) m.beam_angle_rad = radians(pd0::beam_angle_deg[angle]);
  m.convex = bit(word, 3);
  m.faces_up = bit(word, 7);
}

/// Steps of 0.01 mm/s (0.01 mm). A number not greater than `bad` is not valid.
void read_hundredths_of_mm(Bytes block, std::size_t offset, std::int32_t bad, DvlComponents& m) {
  for (std::size_t i = 0; i < m.size(); ++i) {
    const auto raw = load_le<std::int32_t>(block, offset + 4 * i);
    if (raw > bad) m[i] = raw / 1e5;
  }
}

/// Steps of 0.1 mm. 0 means no value.
std::optional<double> tenths_of_mm(Bytes block, std::size_t offset) {
  const auto raw = load_le<std::int32_t>(block, offset);
  return raw == 0 ? std::nullopt : std::optional{raw / 1e4};
}

/// The clock, with its century if the block has one (real-time clock of year 2000 firmware).
/// Without one the years 90 to 99 are of the last century (Teledyne's manuals, command TS).
std::optional<std::chrono::local_time<std::chrono::milliseconds>> read_clock(Bytes block) {
  using namespace std::chrono;
  const bool has_century = block.size() >= 65 && block[57] != 0;
  const Bytes at = block.subspan(has_century ? 58 : 4, 7);
  constexpr int first_of_1900s = 90;
  const int century = has_century ? block[57] : at[0] < first_of_1900s ? 20 : 19;
  const year_month_day date{year{century * 100 + at[0]}, month{at[1]}, day{at[2]}};
  if (!date.ok() || at[3] > 23 || at[4] > 59 || at[5] > 59 || at[6] > 99) return std::nullopt;
  return local_days{date} + hours{at[3]} + minutes{at[4]} + std::chrono::seconds{at[5]} +
         milliseconds{10 * at[6]};
}

}  // namespace

bool read_block(Bytes block, Pd0FixedLeader& m) {
  if (block.size() < 32) return false;
  m.firmware_version = block[2];
  m.firmware_revision = block[3];
  read_system_configuration(load_le<std::uint16_t>(block, 4), m);
  // An angle that the two bits cannot express is in the last byte, in degrees.
  if (!m.beam_angle_rad && block.size() > 58 && block[58] > 0 && block[58] < 90) {
    m.beam_angle_rad = radians(block[58]);
  }
  m.beams = block[8];
  m.cells = block[9];
  m.pings_per_ensemble = load_le<std::uint16_t>(block, 10);
  m.cell_length_m = load_le<std::uint16_t>(block, 12) / 100.0;
  m.blank_m = load_le<std::uint16_t>(block, 14) / 100.0;
  const unsigned transform = block[25];
  m.frame = static_cast<DvlFrame>(transform >> 3 & 3);
  m.tilts_used = bit(transform, 2);
  m.three_beam = bit(transform, 1);
  m.heading_alignment_rad = centidegrees(block, 26);
  m.heading_bias_rad = centidegrees(block, 28);
  m.sensor_source = block[30];
  m.sensors_available = block[31];
  return true;
}

bool read_block(Bytes block, Pd0VariableLeader& m) {
  if (block.size() < 28) return false;
  m.ensemble = load_le<std::uint16_t>(block, 2) + 65536u * block[11];
  m.clock = read_clock(block);
  m.built_in_test = load_le<std::uint16_t>(block, 12);
  if (const auto speed = load_le<std::uint16_t>(block, 14)) m.sound_speed_mps = speed;
  m.depth_m = load_le<std::uint16_t>(block, 16) / 10.0;
  if (const auto heading = load_le<std::uint16_t>(block, 18); heading <= 36000) {
    m.heading_rad = radians(heading / 100.0);
  }
  m.pitch_rad = tilt(block, 20, 9000);
  m.roll_rad = tilt(block, 22, 18000);
  m.salinity_ppt = load_le<std::uint16_t>(block, 24);
  if (const auto celsius = load_le<std::int16_t>(block, 26); celsius != pd0::bad) {
    m.temperature_k = celsius / 100.0 + zero_celsius_k;
  }
  // Signed: near the surface a pressure sensor reads slightly below its zero.
  if (block.size() >= 52) m.pressure_pa = load_le<std::int32_t>(block, 48) * 10.0;
  return true;
}

/// Without water track both distances are 0.
static void read_water_layer(Bytes block, Pd0BottomTrack& m) {
  const auto near_dm = load_le<std::uint16_t>(block, 46),
             far_dm = load_le<std::uint16_t>(block, 48);
  if (far_dm == 0) return;
  m.layer_near_m = near_dm / 10.0;
  m.layer_far_m = far_dm / 10.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto water_mmps = load_le<std::int16_t>(block, 50 + 2 * i);
    if (water_mmps != pd0::bad) m.water_velocity_mps[i] = (0 - water_mmps) / 1000.0;
    m.water_percent_good[i] = block[66 + i];
  }
}

bool read_block(Bytes block, Pd0BottomTrack& m) {
  if (block.size() < 44) return false;
  m.pings_per_ensemble = load_le<std::uint16_t>(block, 2);
  for (std::size_t i = 0; i < 4; ++i) {
    std::uint32_t range_cm = load_le<std::uint16_t>(block, 16 + 2 * i);
    if (block.size() >= 81) range_cm += 65536u * block[77 + i];
    if (range_cm != 0) m.range_m[i] = range_cm / 100.0;
    const auto bed_mmps = load_le<std::int16_t>(block, 24 + 2 * i);
    if (bed_mmps != pd0::bad) m.velocity_mps[i] = (0 - bed_mmps) / 1000.0;
    m.correlation[i] = block[32 + i];
    m.amplitude[i] = block[36 + i];
    m.percent_good[i] = block[40 + i];
  }
  if (block.size() >= 70) read_water_layer(block, m);
  if (block.size() >= 72) m.max_depth_m = load_le<std::uint16_t>(block, 70) / 10.0;
  return true;
}

bool read_block(Bytes block, Pd0HighResolution& m) {
  // The value for a bad velocity of bottom track, and a value that no distance can have.
  constexpr std::int32_t bad_velocity = 100 * pd0::bad;
  constexpr std::int32_t bad_distance = std::numeric_limits<std::int32_t>::min();
  if (block.size() < 18) return false;
  read_hundredths_of_mm(block, 2, bad_velocity, m.bottom_velocity_mps);
  if (block.size() < 66) return true;
  read_hundredths_of_mm(block, 18, bad_distance, m.bottom_distance_m);
  read_hundredths_of_mm(block, 34, bad_velocity, m.water_velocity_mps);
  read_hundredths_of_mm(block, 50, bad_distance, m.water_distance_m);
  return true;
}

bool read_block(Bytes block, Pd0BottomRange& m) {
  if (block.size() < 14) return false;
  m.slant_range_m = tenths_of_mm(block, 2);
  if (m.slant_range_m) m.axis_difference_m = load_le<std::int32_t>(block, 6) / 1e4;
  m.vertical_range_m = tenths_of_mm(block, 10);
  if (block.size() < 33) return true;
  for (std::size_t i = 0; i < 4; ++i) m.beam_range_m[i] = tenths_of_mm(block, 17 + 4 * i);
  return true;
}

bool read_block(Bytes block, Pd0Navigation& m) {
  if (block.size() < 69) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto age_us = load_le<std::uint32_t>(block, 53 + 4 * i);
    if (age_us != 0) m.echo_age[i] = std::chrono::microseconds{age_us};
  }
  return true;
}

}  // namespace drydock::wire
