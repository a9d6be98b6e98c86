#include "hil/emulate/gnss/gnss_epoch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "estimators/frame/geodetic.hpp"
#include "hil/sensor/ideal.hpp"
#include "hil/sky/gps_time.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::emulate {
namespace {

using namespace std::chrono;

// A receiver never reports perfect accuracy.
constexpr double best_accuracy_m = 0.01;
constexpr double best_accuracy_mps = 0.001;

void forget_gps(measurement::GnssSatellites& sky) {
  auto& all = sky.satellites;
  const auto forgotten = std::remove_if(all.begin(), all.end(), [](const auto& satellite) {
    return satellite.constellation == measurement::Constellation::gps;
  });
  all.erase(forgotten, all.end());
}

double spread(const rig_config::SensorErrors& errors, std::size_t axis) {
  return std::hypot(errors.bias[axis], errors.noise[axis], errors.bias_instability[axis]);
}

}  // namespace

double course_rad(const Eigen::Vector3d& velocity_ned) {
  const double angle = std::atan2(velocity_ned.y(), velocity_ned.x());
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

GnssSensor::GnssSensor(const DeviceSetup& setup)
    : condition_(setup.condition),
      boot_(setup.boot),
      first_fix_(measurement::from_seconds(setup.config.emulate.first_fix_s)),
      lowest_cno_dbhz_(setup.config.emulate.sky.value_or(rig_config::SkyConfig{}).lowest_cno_dbhz),
      sky_(setup.sky),
      position_errors_(setup.primary_errors()),
      velocity_errors_(setup.secondary_errors()) {
  const auto& position = setup.config.emulate.primary;
  const auto& velocity = setup.config.emulate.secondary;
  horizontal_accuracy_m_ =
      std::max(best_accuracy_m, std::hypot(spread(position, 0), spread(position, 1)));
  vertical_accuracy_m_ = std::max(best_accuracy_m, spread(position, 2));
  speed_accuracy_mps_ =
      std::max({best_accuracy_mps, spread(velocity, 0), spread(velocity, 1), spread(velocity, 2)});
}

void GnssSensor::add_errors(measurement::GnssFix& fix) {
  const auto moved = frame::at_ned_offset(
      {fix.position->latitude_rad, fix.position->longitude_rad, *fix.ellipsoidal_height_m},
      position_errors_.apply(Eigen::Vector3d::Zero(), fix.origin.valid_at));
  fix.position = measurement::Geodetic{moved.latitude_rad, moved.longitude_rad};
  fix.ellipsoidal_height_m = fix.mean_sea_level_height_m = moved.height_m;
  fix.velocity_ned = velocity_errors_.apply(*fix.velocity_ned, fix.origin.valid_at);
  fix.horizontal_accuracy_m = horizontal_accuracy_m_;
  fix.vertical_accuracy_m = vertical_accuracy_m_;
  fix.speed_accuracy_mps = speed_accuracy_mps_;
}

/// Removes satellites that faults hide: they are behind obstacles, or too weak for the antenna.
void GnssSensor::hide(measurement::GnssSatellites& sky) const {
  auto& all = sky.satellites;
  if (const Trouble* blocked = condition_->under(FaultKind::satellites_blocked)) {
    const double below_rad = blocked->amount * std::numbers::pi / 180;
    const auto hidden = std::remove_if(all.begin(), all.end(), [&](const auto& satellite) {
      return satellite.elevation_rad && *satellite.elevation_rad < below_rad;
    });
    all.erase(hidden, all.end());
  }
  const Trouble* antenna = condition_->under(FaultKind::antenna_gain);
  if (!antenna || antenna->amount == 0) return;
  for (auto& satellite : sky.satellites) {
    if (!satellite.cno_dbhz) continue;
    *satellite.cno_dbhz += antenna->amount;
    if (*satellite.cno_dbhz >= lowest_cno_dbhz_) continue;
    satellite.cno_dbhz.reset();
    satellite.used = false;
  }
}

void GnssSensor::search(GnssEpoch& epoch, Stamp at) const {
  const double part = std::chrono::duration<double>(at - boot_) / first_fix_;
  auto& satellites = epoch.sky.satellites;
  std::ranges::stable_sort(satellites, std::ranges::greater{},
                           [](const auto& s) { return s.cno_dbhz.value_or(0); });
  satellites.resize(static_cast<std::size_t>(part * static_cast<double>(satellites.size())));
  for (auto& satellite : satellites) satellite.used = false;
  epoch.time_is_known = part >= 0.5;
}

void GnssSensor::search_again(Stamp at, std::chrono::nanoseconds until_fix) {
  boot_ = at;
  first_fix_ = until_fix;
}

GnssEpoch GnssSensor::measure(const motion::Truth& truth, const sensor::Mounting& mounting) {
  GnssEpoch epoch;
  epoch.fix = sensor::ideal_gnss(truth, mounting);
  epoch.sky.origin.valid_at = truth.at;
  if (epoch.fix.type != measurement::FixType::none) epoch.sky = sky_->at(truth);
  hide(epoch.sky);
  if (!receives_gps_) forget_gps(epoch.sky);
  if (truth.at - boot_ < first_fix_) search(epoch, truth.at);
  const auto used = std::ranges::count_if(epoch.sky.satellites, &measurement::Satellite::used);
  epoch.dilution = sky::dilution(epoch.sky.satellites);
  if (epoch.dilution) {
    add_errors(epoch.fix);
    epoch.fix.position_dop = epoch.dilution->position;
  } else {
    measurement::GnssFix none;
    none.origin = epoch.fix.origin;
    none.utc = epoch.fix.utc;
    epoch.fix = none;
  }
  epoch.fix.satellites_used = static_cast<int>(used);

  const Stamp clock = condition_->clock.shows(truth.at);
  const sys_time<nanoseconds> utc{clock.time_since_epoch()};
  const auto midnight = floor<days>(utc);
  epoch.date = year_month_day{midnight};
  epoch.time_of_day = utc - midnight;
  const sky::GpsWeek week = sky::week_of(sky::gps_time(clock));
  epoch.week = week.week;
  epoch.leap_seconds = sky::gps_ahead_of_utc(clock);
  epoch.time_of_week = duration_cast<milliseconds>(week.of_week);
  return epoch;
}

}  // namespace drydock::emulate
