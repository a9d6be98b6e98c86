#include "hil/emulate/dvl/wayfinder_structures.hpp"

#include <algorithm>
#include <span>

#include "drivers/wire/bytes.hpp"

namespace drydock::emulate::wayfinder {
namespace {

using wire::load_le, wire::store_le;
using Structure = std::span<std::uint8_t>;

enum Ids : std::uint8_t { system_id = 0x21, setup_id, clock_id, tests_id, features_id = 0x26 };

constexpr std::uint8_t version = 0x10;
constexpr std::size_t system_size = 135, setup_size = 16, clock_size = 12, tests_size = 12,
                      features_size = 7;

Structure append(std::vector<std::uint8_t>& out, Ids id, std::size_t size) {
  const std::size_t begin = out.size();
  out.resize(begin + size);
  const Structure added = Structure{out}.subspan(begin);
  added[0] = id;
  added[1] = version;
  store_le<std::uint32_t>(added, 2, static_cast<std::uint32_t>(size));
  return added;
}

std::uint8_t byte(unsigned value) { return static_cast<std::uint8_t>(value); }

}  // namespace

void append_clock(std::vector<std::uint8_t>& out, WayfinderDialogue::Clock clock) {
  using namespace std::chrono;
  const sys_seconds at{clock};
  const auto day = floor<days>(at);
  const year_month_day date{day};
  const hh_mm_ss time{at - day};
  const Structure s = append(out, clock_id, clock_size);
  s[6] = byte(static_cast<unsigned>(static_cast<int>(date.year()) % 100));
  s[7] = byte(static_cast<unsigned>(date.month()));
  s[8] = byte(static_cast<unsigned>(date.day()));
  s[9] = byte(static_cast<unsigned>(time.hours().count()));
  s[10] = byte(static_cast<unsigned>(time.minutes().count()));
  s[11] = byte(static_cast<unsigned>(time.seconds().count()));
}

/// 614.4 kHz, firmware 1.0.0.0, beams at 30 degrees, no vertical beam, no boards told.
void append_system(std::vector<std::uint8_t>& out) {
  const Structure s = append(out, system_id, system_size);
  store_le<float>(s, 6, 614'400.0F);
  s[10] = 1;
  store_le<float>(s, 27, 30.0F);
  s[133] = byte(system_type);
}

void append_setup(std::vector<std::uint8_t>& out, const WayfinderSetup& setup) {
  const Structure s = append(out, setup_id, setup_size);
  s[6] = setup.software_trigger;
  s[7] = byte(setup.baud_type);
  store_le<float>(s, 8, setup.sound_speed_mps);
  store_le<float>(s, 12, setup.longest_range_m);
}

void append_tests(std::vector<std::uint8_t>& out) {
  std::ranges::fill(append(out, tests_id, tests_size).subspan(6), std::uint8_t{1});
}

void append_features(std::vector<std::uint8_t>& out) {
  append(out, features_id, features_size)[6] = 1;
}

std::optional<WayfinderDialogue::Clock> clock_of(wire::Bytes s) {
  using namespace std::chrono;
  if (s.size() < clock_size || s[0] != clock_id) return {};
  const year_month_day date{year{2000 + s[6]}, month{s[7]}, day{s[8]}};
  if (!date.ok() || s[9] > 23 || s[10] > 59 || s[11] > 59) return {};
  return sys_days{date}.time_since_epoch() + hours{s[9]} + minutes{s[10]} + seconds{s[11]};
}

std::optional<WayfinderSetup> setup_of(wire::Bytes s) {
  if (s.size() < setup_size || s[0] != setup_id) return {};
  return WayfinderSetup{s[6] != 0, s[7], load_le<float>(s, 8), load_le<float>(s, 12)};
}

}  // namespace drydock::emulate::wayfinder
