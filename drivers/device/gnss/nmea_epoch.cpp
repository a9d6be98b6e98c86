#include "drivers/device/gnss/nmea_epoch.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace drydock::device {

using measurement::FixQuality;
using measurement::FixType;
using measurement::GnssFix;

namespace {
constexpr int quality_estimated = 6;  // 7 is manual input, 8 simulation: no measurements

/// The best fix type of all constellations in a GNS, if none of them measured. Empty if the
/// position was measured. Manual input (M) and simulation (S) are no measurements.
std::optional<FixType> other_than_measured(const wire::Gns& gns) {
  const auto has = [&](std::string_view letters) {
    return std::ranges::any_of(gns.modes, [=](char c) { return letters.find(c) != letters.npos; });
  };
  if (has("ADPRF")) return {};
  // Without any mode only its satellites say that it measured.
  if (!has("NEMS") && gns.satellites_used.value_or(0) > 0) return {};
  return has("E") ? FixType::dead_reckoning : FixType::none;
}

/// GGA's quality. PPS (3) has a better code, but no corrections.
std::optional<FixQuality> quality_of(int gga_quality) {
  switch (gga_quality) {
    case 1:
    case 3: return FixQuality::autonomous;
    case 2: return FixQuality::differential;
    case 4: return FixQuality::rtk_fixed;
    case 5: return FixQuality::rtk_float;
    case quality_estimated: return FixQuality::dead_reckoning;
    default: return {};
  }
}

/// The best of the modes of GNS (one for each constellation), RMC or GLL. Those of PPS (P) count as
/// autonomous.
std::optional<FixQuality> quality_of(std::string_view modes) {
  constexpr std::pair<char, FixQuality> best_first[] = {
      {'R', FixQuality::rtk_fixed},    {'F', FixQuality::rtk_float},
      {'D', FixQuality::differential}, {'P', FixQuality::autonomous},
      {'A', FixQuality::autonomous},   {'E', FixQuality::dead_reckoning}};
  for (const auto& [letter, quality] : best_first)
    if (modes.find(letter) != modes.npos) return quality;
  return {};
}

template <class Sentence>
void take_position(const std::optional<Sentence>& s, GnssFix& fix) {
  if (fix.position || !s || !s->latitude_rad || !s->longitude_rad) return;
  fix.position = {*s->latitude_rad, *s->longitude_rad};
  if constexpr (requires { s->geoid_separation_m; }) {
    fix.mean_sea_level_height_m = s->mean_sea_level_height_m;
    if (s->mean_sea_level_height_m && s->geoid_separation_m) {
      fix.ellipsoidal_height_m = *s->mean_sea_level_height_m + *s->geoid_separation_m;
    }
  }
}
}  // namespace

void NmeaEpoch::begin(const Origin& origin, const TimeOfDay& time_of_day) {
  if (!began_) {
    began_ = origin;
    first_at_ = origin.received_at;
  }
  began_->received_at = origin.received_at;
  time_of_day_ = std::max(time_of_day_, time_of_day);  // the one with most decimals; empty is least
  last_is_gsa_ = false;
}

bool NmeaEpoch::differs(const TimeOfDay& time_of_day, bool have_one) const {
  if (time_of_day && time_of_day_) return !is_same(time_of_day, time_of_day_);
  return have_one;
}

/// Some receivers send one GGA for each constellation, with the satellites of this one alone.
void NmeaEpoch::add(const wire::Gga& s, const Origin& origin) {
  constexpr wire::Talker of_all{"GN"};
  begin(origin, s.time_of_day);
  if (gga_ && gga_->talker != s.talker) {
    if (gga_->talker == of_all) return;
    used_by_others_ = s.talker == of_all ? 0 : used_by_others_ + gga_->satellites_used.value_or(0);
  }
  gga_ = s;
}

void NmeaEpoch::add(const wire::Gns& s, const Origin& origin) {
  begin(origin, s.time_of_day);
  // After the GN sentence some receivers send one sentence for each constellation, without a
  // position.
  if (!gns_ || s.latitude_rad) gns_ = s;
}

void NmeaEpoch::add(const wire::Gsa& s, const Origin& origin) {
  begin(origin, {});
  // There is one per constellation. They agree on the fix, except that one without satellites may
  // show none.
  if (s.fix_type) gsa_fix_type_ = std::max(gsa_fix_type_.value_or(0), *s.fix_type);
  if (s.position_dop) position_dop_ = s.position_dop;
  satellites_.add(s);
  last_is_gsa_ = true;
}

void NmeaEpoch::clear() { *this = {}; }

FixType NmeaEpoch::fix_type() const {
  if (rmc_ && !rmc_->valid) return FixType::none;
  if (gga_) {
    const int quality = gga_->quality.value_or(0);
    if (quality < 1 || quality > quality_estimated) return FixType::none;
    if (quality == quality_estimated) return FixType::dead_reckoning;
  }
  if (!gga_ && gns_) {
    if (const auto type = other_than_measured(*gns_)) return *type;
  }
  if (!gga_ && !gns_ && !rmc_ && gll_ && !gll_->valid) return FixType::none;
  if (gsa_fix_type_ == 3) return FixType::three_d;
  if (gsa_fix_type_ == 2) return FixType::two_d;
  if (gsa_fix_type_ == 1) return FixType::none;
  const bool has_height =
      (gga_ && gga_->mean_sea_level_height_m) || (!gga_ && gns_ && gns_->mean_sea_level_height_m);
  return has_height ? FixType::three_d : FixType::two_d;
}

std::optional<FixQuality> NmeaEpoch::quality() const {
  if (gga_ && gga_->quality) return quality_of(*gga_->quality);
  if (gns_) return quality_of(std::string_view(gns_->modes.data(), gns_->modes.size()));
  if (rmc_) return quality_of(rmc_->mode.text().value_or(""));
  if (gll_) return quality_of(gll_->mode.text().value_or(""));
  return {};
}

std::optional<GnssFix> NmeaEpoch::fix() const {
  if (!began_ || !has_position_sentence()) return {};
  GnssFix fix;
  fix.origin = *began_;
  fix.origin.device_time = time_of_day_;
  fix.type = fix_type();
  fix.satellites_used = satellites_used();
  fix.position_dop = position_dop_;
  if (fix.type == FixType::none) return fix;
  fix.quality = quality();
  fill_position(fix);
  fill_accuracy(fix);
  fill_motion(fix);
  fix.utc = utc();
  return fix;
}

/// GNS has one number for all constellations; a GGA beside it may count those of its talker alone.
std::optional<int> NmeaEpoch::satellites_used() const {
  if (gns_ && gns_->satellites_used) return gns_->satellites_used;
  if (!gga_ || !gga_->satellites_used) return {};
  return *gga_->satellites_used + used_by_others_;
}

void NmeaEpoch::fill_position(GnssFix& fix) const {
  take_position(gga_, fix);
  take_position(gns_, fix);
  take_position(rmc_, fix);
  take_position(gll_, fix);
}

void NmeaEpoch::fill_accuracy(GnssFix& fix) const {
  if (!gst_) return;
  if (gst_->latitude_sigma_m && gst_->longitude_sigma_m) {
    fix.horizontal_accuracy_m = std::hypot(*gst_->latitude_sigma_m, *gst_->longitude_sigma_m);
  }
  fix.vertical_accuracy_m = gst_->height_sigma_m;
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
  if (!time_of_day_ || (has_position_sentence() && fix_type() == FixType::none)) return {};
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
