#include "drivers/device/gnss/ubx_epoch.hpp"

#include <cmath>
#include <numbers>

#include "drivers/device/gnss/ecef.hpp"

namespace drydock::device {

using measurement::FixQuality;
using measurement::FixType;
using measurement::GnssFix;
using measurement::Stamp;

namespace {

constexpr std::chrono::seconds gps_began{315'964'800};  // 1980-01-06, since 1970

std::optional<Eigen::Vector3d> vector_of(const wire::Ecef& ecef) {
  if (!ecef[0] || !ecef[1] || !ecef[2]) return {};
  return Eigen::Vector3d{*ecef[0], *ecef[1], *ecef[2]};
}

double course(const Eigen::Vector3d& velocity_ned) {
  const double angle = std::atan2(velocity_ned.y(), velocity_ned.x());
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

}  // namespace

FixType fix_type(wire::UbxFixType type, bool fix_ok) {
  switch (type) {
    case wire::UbxFixType::none: return FixType::none;
    case wire::UbxFixType::time_only: return FixType::time_only;
    case wire::UbxFixType::dead_reckoning: return fix_ok ? FixType::dead_reckoning : FixType::none;
    case wire::UbxFixType::two_d: return fix_ok ? FixType::two_d : FixType::none;
    case wire::UbxFixType::three_d: return fix_ok ? FixType::three_d : FixType::none;
    case wire::UbxFixType::gnss_and_dr: return fix_ok ? FixType::gnss_and_dr : FixType::none;
  }
  return FixType::none;
}

std::optional<FixQuality> fix_quality(FixType type, bool differential, unsigned carrier_solution) {
  if (type == FixType::none || type == FixType::time_only) return {};
  if (type == FixType::dead_reckoning) return FixQuality::dead_reckoning;
  if (carrier_solution == 2) return FixQuality::rtk_fixed;
  if (carrier_solution == 1) return FixQuality::rtk_float;
  return differential ? FixQuality::differential : FixQuality::autonomous;
}

void UbxEpoch::begin(const Origin& origin) {
  if (!began_) began_ = origin;
  began_->received_at = origin.received_at;
}

void UbxEpoch::add(const wire::NavSvinfo& m, const Origin& origin) {
  begin(origin);
  satellites_ = satellite_list(m.satellites);
  has_channels_ = true;
}

void UbxEpoch::add(const wire::NavSig& m, const Origin& origin) {
  begin(origin);
  if (!has_channels_) satellites_ = satellite_list(m.signals);
}

bool UbxEpoch::vouched_for() const {
  if (sol_) return wire::vouched_for(sol_->fix_type, sol_->fix_ok);
  return status_ && wire::vouched_for(status_->fix_type, status_->fix_ok);
}

std::optional<GnssFix> UbxEpoch::fix() const {
  if (!began_ || (!sol_ && !status_ && !posllh_ && !velned_)) return {};
  GnssFix fix;
  fix.origin = *began_;
  if (sol_) {
    fix.type = fix_type(sol_->fix_type, sol_->fix_ok);
    fix.quality = fix_quality(fix.type, sol_->differential);
    fix.satellites_used = sol_->satellites_used;
    fix.position_dop = sol_->position_dop;
  } else if (status_) {
    fix.type = fix_type(status_->fix_type, status_->fix_ok);
    fix.quality = fix_quality(fix.type, status_->differential);
  }
  if (dop_) fix.position_dop = dop_->position;
  fix.utc = utc();
  if (!vouched_for()) return fix;
  fill_position(fix);
  fill_velocity(fix);
  return fix;
}

void UbxEpoch::fill_position(GnssFix& fix) const {
  const auto ecef = sol_ ? vector_of(sol_->position_ecef_m) : std::nullopt;
  if (posllh_ && posllh_->latitude_rad && posllh_->longitude_rad) {
    fix.position = {*posllh_->latitude_rad, *posllh_->longitude_rad};
    fix.ellipsoidal_height_m = posllh_->ellipsoidal_height_m;
    fix.mean_sea_level_height_m = posllh_->mean_sea_level_height_m;
    fix.horizontal_accuracy_m = posllh_->horizontal_accuracy_m;
    fix.vertical_accuracy_m = posllh_->vertical_accuracy_m;
  } else if (ecef) {  // its accuracy is for all three axes together
    const EllipsoidalPosition position = from_ecef(*ecef);
    fix.position = position.horizontal;
    fix.ellipsoidal_height_m = position.height_m;
  }
}

void UbxEpoch::fill_velocity(GnssFix& fix) const {
  const auto ecef = sol_ ? vector_of(sol_->velocity_ecef_mps) : std::nullopt;
  if (velned_ && velned_->velocity_north_mps) {
    fix.velocity_ned = {*velned_->velocity_north_mps, *velned_->velocity_east_mps,
                        *velned_->velocity_down_mps};
    fix.ground_speed_mps = velned_->ground_speed_mps;
    fix.course_rad = velned_->course_rad;
    fix.speed_accuracy_mps = velned_->speed_accuracy_mps;
  } else if (ecef && fix.position) {
    fix.velocity_ned = ned_of_ecef(*ecef, *fix.position);
    fix.ground_speed_mps = fix.velocity_ned->head<2>().norm();
    fix.course_rad = course(*fix.velocity_ned);
    fix.speed_accuracy_mps = sol_->speed_accuracy_mps;
  }
}

/// UTC as the receiver gives it. Otherwise GPS time minus the leap seconds, if the receiver knows
/// them. GPS time without leap seconds is not UTC.
std::optional<Stamp> UbxEpoch::utc() const {
  if (time_utc_ && time_utc_->date && time_utc_->time_of_day) {
    return Stamp{std::chrono::sys_days{*time_utc_->date}.time_since_epoch() +
                 *time_utc_->time_of_day};
  }
  if (!time_gps_ || !time_gps_->time_known || !time_gps_->gps_week || !time_gps_->leap_seconds) {
    return {};
  }
  return Stamp{gps_began + std::chrono::weeks{*time_gps_->gps_week} + time_gps_->itow +
               time_gps_->itow_fraction - std::chrono::seconds{*time_gps_->leap_seconds}};
}

std::optional<measurement::GnssSatellites> UbxEpoch::satellites() const {
  if (!began_ || !satellites_) return {};
  return measurement::GnssSatellites{*began_, *satellites_};
}

}  // namespace drydock::device
