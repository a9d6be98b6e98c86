#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/fields.hpp"

/// Data type 0x2000: navigation that a computer outside of the instrument put into its ensembles.
/// Two layouts stand under this number: that of VmDas on ships (VmDas User's Guide P/N 95A-6015-00,
/// as MHKiT-Python reads it), and that of a REMUS vehicle (found by comparison of a dive with its
/// bottom track; no document).
namespace drydock::wire {

namespace pd0 {
constexpr std::uint16_t computer_navigation = 0x2000;
}

/// Empty where the flag of the block does not say that it is valid.
struct VmdasFix {
  std::optional<std::chrono::microseconds> time_of_day;  ///< UTC
  std::optional<double> latitude_rad, longitude_rad;     ///< north and east are positive
};

struct VmdasNavigation {
  std::uint16_t flags = 0;                          ///< as sent
  std::optional<std::chrono::year_month_day> date;  ///< UTC
  VmdasFix first, last;                  ///< of those between the ensemble before and this one
  std::optional<double> clock_offset_s;  ///< the computer's clock from UTC
  std::optional<double> speed_mps;       ///< over ground, mean
  std::optional<double> course_true_rad, course_magnetic_rad;  ///< mean
  std::optional<double> speed_made_good_mps, course_made_good_rad;
  std::optional<double> pitch_rad, roll_rad, heading_rad;  ///< of the ship's sensors
};

/// The position is a dead reckoning with the same DVL that position fixes set right.
struct RemusNavigation {
  std::optional<std::chrono::year_month_day> date;
  double latitude_rad = 0, longitude_rad = 0, speed_mps = 0, heading_rad = 0;
};

/// At most one of both.
struct Pd0ComputerNavigation {
  std::optional<VmdasNavigation> vmdas;
  std::optional<RemusNavigation> remus;
};

/// False if the block is neither: another size, or its date is none.
bool read_block(Bytes block, Pd0ComputerNavigation& m);

/// A list of one or of none, for `field`.
template <class T>
std::span<const T> as_list(const std::optional<T>& one) {
  return one ? std::span<const T>(&*one, 1) : std::span<const T>();
}

template <class F>
void visit_fields(const VmdasFix& m, F&& field) {
  field("time_of_day_s", seconds(m.time_of_day));
  field("latitude_deg", degrees(m.latitude_rad));
  field("longitude_deg", degrees(m.longitude_rad));
}

template <class F>
void visit_fields(const VmdasNavigation& m, F&& field) {
  field("flags", m.flags);
  visit_date(m.date, field);
  field("first", std::span(&m.first, 1));
  field("last", std::span(&m.last, 1));
  field("clock_offset_s", m.clock_offset_s);
  field("speed_mps", m.speed_mps);
  field("course_true_deg", degrees(m.course_true_rad));
  field("course_magnetic_deg", degrees(m.course_magnetic_rad));
  field("speed_made_good_mps", m.speed_made_good_mps);
  field("course_made_good_deg", degrees(m.course_made_good_rad));
  field("pitch_deg", degrees(m.pitch_rad));
  field("roll_deg", degrees(m.roll_rad));
  field("heading_deg", degrees(m.heading_rad));
}

template <class F>
void visit_fields(const RemusNavigation& m, F&& field) {
  visit_date(m.date, field);
  field("latitude_deg", degrees(m.latitude_rad));
  field("longitude_deg", degrees(m.longitude_rad));
  field("speed_mps", m.speed_mps);
  field("heading_deg", degrees(m.heading_rad));
}

template <class F>
void visit_fields(const Pd0ComputerNavigation& m, F&& field) {
  field("vmdas", as_list(m.vmdas));
  field("remus", as_list(m.remus));
}

}  // namespace drydock::wire
