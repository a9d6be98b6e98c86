#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/fields.hpp"

/// The time as a u-blox receiver knows it: GPS weeks, leap seconds, UTC (u-blox interface
/// descriptions, class 0x01).
namespace drydock::wire {

struct NavTimeGps {
  static constexpr std::string_view type = "NAV-TIMEGPS";
  static constexpr std::uint16_t class_and_id = 0x0120;
  std::chrono::milliseconds itow{};
  std::chrono::nanoseconds itow_fraction{};  ///< signed, to be added to iTOW
  bool time_known = false;
  std::optional<int> gps_week;
  std::optional<int> leap_seconds;  ///< GPS - UTC; empty until the receiver knows it
  std::optional<double> time_accuracy_s;
};

struct NavTimeUtc {
  static constexpr std::string_view type = "NAV-TIMEUTC";
  static constexpr std::uint16_t class_and_id = 0x0121;
  std::chrono::milliseconds itow{};
  std::optional<double> time_accuracy_s;
  /// Both empty until week, time of week and leap seconds are known.
  std::optional<std::chrono::year_month_day> date;
  std::optional<std::chrono::nanoseconds> time_of_day;  ///< may be slightly negative
};

bool read(Bytes payload, NavTimeGps& m);
bool read(Bytes payload, NavTimeUtc& m);

/// Returns the bytes of the whole frame, 0 if `out` is too small.
std::size_t encode(const NavTimeGps& m, std::span<std::uint8_t> out);

template <class F>
void visit_fields(const NavTimeGps& m, F&& field) {
  field("itow_s", seconds(m.itow));
  field("itow_fraction_s", seconds(m.itow_fraction));
  field("time_known", m.time_known);
  field("gps_week", m.gps_week);
  field("leap_seconds", m.leap_seconds);
  field("time_accuracy_s", m.time_accuracy_s);
}

template <class F>
void visit_fields(const NavTimeUtc& m, F&& field) {
  field("itow_s", seconds(m.itow));
  field("time_accuracy_s", m.time_accuracy_s);
  visit_date(m.date, field);
  field("time_of_day_s", seconds(m.time_of_day));
}

}  // namespace drydock::wire
