#include "drivers/wire/dvl/pd0_vmdas.hpp"

#include <cmath>
#include <numbers>

#include "drivers/wire/bytes.hpp"

namespace drydock::wire {
namespace {

using std::chrono::year_month_day;

constexpr std::size_t vmdas_size = 78, remus_size = 48;

/// Binary angles: a half turn is the sign bit.
double angle_of_32_bits(Bytes block, std::size_t at) {
  return load_le<std::int32_t>(block, at) * (std::numbers::pi / 0x1p31);
}
double tilt_of_16_bits(Bytes block, std::size_t at) {
  return load_le<std::int16_t>(block, at) * (std::numbers::pi / 0x1p15);
}
double direction_of_16_bits(Bytes block, std::size_t at) {
  return load_le<std::uint16_t>(block, at) * (std::numbers::pi / 0x1p15);
}
double speed(Bytes block, std::size_t at) { return load_le<std::uint16_t>(block, at) / 1e3; }

bool is_place(double latitude_rad) { return std::abs(latitude_rad) <= std::numbers::pi / 2; }

/// Bits of the flags. Bit 0 tells that anything is new.
enum Valid : unsigned {
  position = 1u << 1,
  over_ground = 1u << 2,
  magnetic_track = 1u << 3,
  true_track = 1u << 4,
  date_and_time = 1u << 5,
  made_good = 1u << 6,
  tilts = 1u << 7,
  heading = 1u << 8,
  clock_offset = 1u << 10
};

VmdasFix vmdas_fix(Bytes block, std::size_t at, unsigned flags) {
  VmdasFix m;
  const std::chrono::microseconds time_of_day{load_le<std::uint32_t>(block, at) * 100LL};
  if (flags & date_and_time && time_of_day <= std::chrono::days{1}) m.time_of_day = time_of_day;
  const std::size_t place = at + (at == 6 ? 8 : 4);  // behind the first is the clock's offset
  const double latitude_rad = angle_of_32_bits(block, place);
  if (!(flags & position) || !is_place(latitude_rad)) return m;
  m.latitude_rad = latitude_rad;
  m.longitude_rad = angle_of_32_bits(block, place + 4);
  return m;
}

bool read_vmdas(Bytes block, VmdasNavigation& m) {
  if (block.size() < vmdas_size) return false;
  const unsigned flags = load_le<std::uint16_t>(block, 46);
  const year_month_day date{std::chrono::year{load_le<std::uint16_t>(block, 4)},
                            std::chrono::month{block[3]}, std::chrono::day{block[2]}};
  if (flags & date_and_time) {
    if (!date.ok()) return false;
    m.date = date;
  }
  m.flags = static_cast<std::uint16_t>(flags);
  m.first = vmdas_fix(block, 6, flags);
  m.last = vmdas_fix(block, 22, flags);
  if (flags & clock_offset) m.clock_offset_s = load_le<std::int32_t>(block, 10) / 1e3;
  if (flags & over_ground) m.speed_mps = speed(block, 34);
  if (flags & true_track) m.course_true_rad = direction_of_16_bits(block, 36);
  if (flags & magnetic_track) m.course_magnetic_rad = direction_of_16_bits(block, 38);
  if (flags & made_good) {
    m.speed_made_good_mps = speed(block, 40);
    m.course_made_good_rad = direction_of_16_bits(block, 42);
  }
  if (flags & tilts) {
    m.pitch_rad = tilt_of_16_bits(block, 62);
    m.roll_rad = tilt_of_16_bits(block, 64);
  }
  if (flags & heading) m.heading_rad = direction_of_16_bits(block, 66);
  return true;
}

/// Its months count from 0.
bool read_remus(Bytes block, RemusNavigation& m) {
  if (block.size() < remus_size || block.size() >= vmdas_size) return false;
  const year_month_day date{std::chrono::year{load_le<std::uint16_t>(block, 2)},
                            std::chrono::month{block[5] + 1u}, std::chrono::day{block[4]}};
  m.date = date;
  m.latitude_rad = angle_of_32_bits(block, 16);
  m.longitude_rad = angle_of_32_bits(block, 20);
  m.speed_mps = speed(block, 36);
  m.heading_rad = direction_of_16_bits(block, 38);
  return date.ok() && is_place(m.latitude_rad);
}

}  // namespace

bool read_block(Bytes block, Pd0ComputerNavigation& m) {
  if (block.size() < 2 || load_le<std::uint16_t>(block, 0) != pd0::computer_navigation)
    return false;
  if (VmdasNavigation vmdas; read_vmdas(block, vmdas)) {
    m.vmdas = vmdas;
    return true;
  }
  RemusNavigation remus;
  if (!read_remus(block, remus)) return false;
  m.remus = remus;
  return true;
}

}  // namespace drydock::wire
