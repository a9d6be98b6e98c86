#include "drivers/device/gnss/nmea2000_epoch.hpp"

#include <array>
#include <cmath>

#include "drivers/device/gnss/nmea_satellites.hpp"

namespace drydock::device {

using measurement::FixQuality;
using measurement::FixType;
using measurement::GnssFix;

namespace {

constexpr std::chrono::milliseconds epoch_lasts{500};

/// What the method of PGN 129029 means. Manual input and a simulator (7, 8) vouch for no position.
struct Method {
  FixType type;
  std::optional<FixQuality> quality;
};
constexpr std::array methods{Method{FixType::none, {}},
                             Method{FixType::three_d, FixQuality::autonomous},
                             Method{FixType::three_d, FixQuality::differential},
                             Method{FixType::three_d, FixQuality::differential},
                             Method{FixType::three_d, FixQuality::rtk_fixed},
                             Method{FixType::three_d, FixQuality::rtk_float},
                             Method{FixType::dead_reckoning, FixQuality::dead_reckoning}};

Method method_of(const wire::nmea2000::GnssPosition& m) {
  const std::size_t number = m.method.value_or(0);
  return number < methods.size() ? methods[number] : methods[0];
}

void fill_place(GnssFix& fix, const wire::nmea2000::GnssPosition& m) {
  if (m.latitude_rad && m.longitude_rad)
    fix.position = measurement::Geodetic{*m.latitude_rad, *m.longitude_rad};
  fix.ellipsoidal_height_m = m.altitude_m;
  if (m.altitude_m && m.geoid_height_m)
    fix.mean_sea_level_height_m = *m.altitude_m - *m.geoid_height_m;
}

std::optional<double> position_dop(const wire::nmea2000::Dilutions& m) {
  if (!m.horizontal_dop || !m.vertical_dop) return std::nullopt;
  return std::hypot(*m.horizontal_dop, *m.vertical_dop);
}

bool is_used(const wire::nmea2000::SatelliteInView& m) { return m.status == 2 || m.status == 5; }

}  // namespace

bool Nmea2000Epoch::is_over(const Origin& origin) const {
  return origin.received_at - began_->received_at > epoch_lasts;
}

std::optional<GnssFix> Nmea2000Epoch::fix() const {
  if (!position_) return std::nullopt;
  GnssFix fix;
  fix.origin = *began_;
  const Method method = method_of(*position_);
  fix.type = method.type;
  fix.quality = method.quality;
  if (position_->utc_ns) {
    fix.utc = measurement::Stamp{std::chrono::nanoseconds{*position_->utc_ns}};
    fix.origin.device_time = std::chrono::nanoseconds{*position_->utc_ns};
  }
  if (method.type != FixType::none) fill_place(fix, *position_);
  if (position_->satellites) fix.satellites_used = *position_->satellites;
  fix.position_dop = position_->position_dop;
  if (!fix.position_dop && dilutions_) fix.position_dop = position_dop(*dilutions_);
  if (course_ && fix.position) fill_motion(fix, *course_);
  return fix;
}

void fill_motion(GnssFix& fix, const wire::nmea2000::CourseAndSpeed& course) {
  constexpr std::uint8_t of_true_north = 0;
  fix.ground_speed_mps = course.speed_mps;
  if (course.reference == of_true_north) fix.course_rad = course.course_rad;
}

measurement::GnssSatellites satellites_of(const wire::nmea2000::SatellitesInView& sky,
                                          const Origin& origin) {
  measurement::GnssSatellites found;
  found.origin = origin;
  for (const auto& seen : sky.satellites) {
    const auto id = identify_satellite({}, {}, seen.number.value_or(0));
    if (!id) continue;
    found.satellites.push_back({id->constellation, id->number, seen.snr_db, seen.elevation_rad,
                                seen.azimuth_rad, is_used(seen)});
  }
  return found;
}

}  // namespace drydock::device
