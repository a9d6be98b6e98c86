#include "drivers/device/nmea_epoch.hpp"

#include <algorithm>

namespace drydock::device {

using measurement::FixType;
using measurement::GnssFix;

namespace {
constexpr int quality_estimated = 6;  // 7 is typed in by hand, 8 simulated: no measurements
}

void NmeaEpoch::begin(const Origin& origin, const TimeOfDay& time_of_day) {
  if (!began_) began_ = origin;
  began_->received_at = origin.received_at;
  if (time_of_day) time_of_day_ = time_of_day;
}

bool NmeaEpoch::differs(const TimeOfDay& time_of_day, bool have_one) const {
  if (time_of_day && time_of_day_) return *time_of_day != *time_of_day_;
  return have_one;
}

void NmeaEpoch::add(const wire::Gsa& s, const Origin& origin) {
  begin(origin, {});
  // One per constellation; they agree on the fix, and a constellation without satellites may not.
  if (s.fix_type) gsa_fix_type_ = std::max(gsa_fix_type_.value_or(0), *s.fix_type);
  if (s.position_dop) position_dop_ = s.position_dop;
  satellites_.add(s);
}

void NmeaEpoch::clear() { *this = {}; }

FixType NmeaEpoch::fix_type() const {
  if (rmc_ && !rmc_->valid) return FixType::none;
  if (gga_) {
    const int quality = gga_->quality.value_or(0);
    if (quality < 1 || quality > quality_estimated) return FixType::none;
    if (quality == quality_estimated) return FixType::dead_reckoning;
  }
  if (gsa_fix_type_ == 3) return FixType::three_d;
  if (gsa_fix_type_ == 2) return FixType::two_d;
  if (gsa_fix_type_ == 1) return FixType::none;
  return gga_ && gga_->mean_sea_level_height_m ? FixType::three_d : FixType::two_d;
}

std::optional<GnssFix> NmeaEpoch::fix() const {
  if (!began_ || (!gga_ && !rmc_)) return {};
  GnssFix fix;
  fix.origin = *began_;
  fix.origin.device_time = time_of_day_;
  fix.type = fix_type();
  if (gga_) fix.satellites_used = gga_->satellites_used;
  fix.position_dop = position_dop_;
  if (fix.type == FixType::none) return fix;
  fill_position(fix);
  fill_motion(fix);
  fix.utc = utc();
  return fix;
}

void NmeaEpoch::fill_position(GnssFix& fix) const {
  if (gga_ && gga_->latitude_rad && gga_->longitude_rad) {
    fix.position = {*gga_->latitude_rad, *gga_->longitude_rad};
    fix.mean_sea_level_height_m = gga_->mean_sea_level_height_m;
    if (gga_->mean_sea_level_height_m && gga_->geoid_separation_m) {
      fix.ellipsoidal_height_m = *gga_->mean_sea_level_height_m + *gga_->geoid_separation_m;
    }
  } else if (rmc_ && rmc_->latitude_rad && rmc_->longitude_rad) {
    fix.position = {*rmc_->latitude_rad, *rmc_->longitude_rad};
  }
}

void NmeaEpoch::fill_motion(GnssFix& fix) const {
  if (rmc_) {
    fix.ground_speed_mps = rmc_->speed_mps;
    fix.course_rad = rmc_->course_rad;
  }
  if (!vtg_) return;
  if (vtg_->speed_mps) fix.ground_speed_mps = vtg_->speed_mps;
  if (vtg_->course_true_rad) fix.course_rad = vtg_->course_true_rad;
}

std::optional<measurement::Stamp> NmeaEpoch::utc() const {
  if (!time_of_day_) return {};
  std::optional<std::chrono::year_month_day> date;
  if (zda_) date = zda_->date;
  if (!date && rmc_) date = rmc_->date;
  if (!date || !date->ok()) return {};
  return measurement::Stamp{std::chrono::sys_days{*date}.time_since_epoch() + *time_of_day_};
}

std::optional<measurement::GnssSatellites> NmeaEpoch::satellites() const {
  if (!began_ || !satellites_.complete_group()) return {};
  measurement::GnssSatellites result;
  result.origin = *began_;
  result.origin.device_time = time_of_day_;
  result.satellites = satellites_.list();
  return result;
}

}  // namespace drydock::device
