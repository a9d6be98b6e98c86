#include <cmath>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/dvl/ad2cp_read.hpp"

namespace drydock::wire::ad2cp {
namespace {

/// Four floats, of which the status vouches for those with a bit from `first_bit` on.
Four read_four(Bytes groups, std::size_t offset, unsigned status, unsigned first_bit) {
  Four four;
  for (unsigned i = 0; i < 4; ++i)
    if ((status >> (first_bit + i) & 1) != 0) four[i] = read_float(groups, offset + 4 * i);
  return four;
}

Estimates read_estimates(Bytes groups, const EstimatesAt& at, unsigned status) {
  const auto four = [&](std::size_t offset, unsigned bit) {
    return read_four(groups, offset, status, bit);
  };
  Estimates estimates;
  estimates.velocity_mps = four(at.velocity, at.velocity_bit);
  estimates.figure_of_merit_mps = four(at.merit, at.merit_bit);
  estimates.after_trigger_s = four(at.after_trigger, at.velocity_bit);
  estimates.after_output_s = four(at.after_output, at.velocity_bit);
  estimates.duration_s = four(at.duration, at.velocity_bit);
  return estimates;
}

void read_front(Bytes data, Track& m) {
  m.version = data[0];
  m.serial_number = load_le<std::uint32_t>(data, serial_at);
  m.clock = read_clock(data.subspan(clock_at));
  m.number_of_beams = load_le<std::uint16_t>(data, beam_count_at);
  m.error = load_le<std::uint32_t>(data, error_at);
  m.status = load_le<std::uint32_t>(data, status_at);
  m.sound_speed_mps = read_float(data, sound_speed_at);
  m.pressure_pa = scaled(read_float(data, bar_at), pa_per_bar);
  if (const auto celsius = read_float(data, celsius_at))
    m.temperature_k = *celsius + zero_celsius_k;
}

}  // namespace

std::optional<double> read_float(Bytes data, std::size_t offset) {
  const auto value = load_le<float>(data, offset);
  return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

std::optional<std::chrono::microseconds> read_clock(Bytes at) {
  using namespace std::chrono;
  const year_month_day date{year{1900 + at[0]}, month{at[1] + 1U}, day{at[2]}};
  const unsigned ticks = load_le<std::uint16_t>(at, 6);
  if (!date.ok() || at[3] > 23 || at[4] > 59 || at[5] > 59 || ticks > 9999) return std::nullopt;
  return sys_days{date}.time_since_epoch() + hours{at[3]} + minutes{at[4]} +
         std::chrono::seconds{at[5]} + microseconds{100 * ticks};
}

bool read(Bytes data, Track& m) {
  if (data.size() < front_size) return false;
  const std::size_t groups_at = data[1];
  if (groups_at < front_size || data.size() < groups_at + groups_size) return false;
  read_front(data, m);
  const Bytes groups = data.subspan(groups_at);
  m.distance_m = read_four(groups, distance_at, m.status, distance_bit);
  m.beams = read_estimates(groups, beams_at, m.status);
  m.axes = read_estimates(groups, axes_at, m.status);
  return true;
}

}  // namespace drydock::wire::ad2cp
