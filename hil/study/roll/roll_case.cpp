#include "hil/study/roll/roll_case.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/attitude.hpp"
#include "hil/sky/antenna.hpp"
#include "hil/sky/broadcast_orbits.hpp"
#include "hil/sky/ephemeris_file.hpp"
#include "hil/sky/look.hpp"

namespace drydock::study {
namespace {

using std::numbers::pi;

constexpr std::size_t skies_wanted = 7, satellites_wanted = 10;
constexpr double least_elevation = 5 * units::degree;
constexpr double nose_over = 45 * units::degree;               // the pitch is from + to - this
                                                               // angle
constexpr double rate_swing = 0.05, rate_swing_period_s = 20;  // the roll rate varies slightly
constexpr frame::Position launch_site{37 * units::degree, 127 * units::degree, 0};
constexpr double reference_distance_m = 100e3;

RollSky sky_at(const sky::BroadcastOrbits& orbits, sky::GpsTime time) {
  std::vector<sky::Look> looks;
  for (int prn = 1; prn <= sky::highest_prn; ++prn) {
    const auto* record = orbits.nearest(prn, time);
    if (record == nullptr) continue;
    const auto look = sky::look_at(*record, time, launch_site);
    if (look.elevation_rad >= least_elevation) looks.push_back(look);
  }
  std::ranges::sort(looks, std::ranges::greater{}, &sky::Look::elevation_rad);
  RollSky found{launch_site, {}};
  for (std::size_t i = 0; i < std::min(satellites_wanted, looks.size()); ++i)
    found.toward_ned.push_back(looks[i].toward_ned);
  return found;
}

double rounded_to_degrees(double angle) {
  return std::round(angle / units::degree) * units::degree;
}

}  // namespace

std::vector<RollSky> roll_skies(const std::string& ephemeris_file) {
  const auto file = sky::read_navigation_file(ephemeris_file);
  if (!file) throw std::runtime_error(file.error().message);
  const sky::BroadcastOrbits orbits(file->records);
  std::vector<RollSky> all;
  const auto [first, last] = orbits.span();
  for (auto t = first; t <= last; t += std::chrono::minutes{15})
    if (auto sky = sky_at(orbits, t); sky.toward_ned.size() == satellites_wanted)
      all.push_back(std::move(sky));
  if (all.empty())
    throw std::runtime_error(ephemeris_file +
                             ": never ten healthy GPS satellites above 5 deg at 37 N 127 E");
  std::vector<RollSky> chosen;
  for (std::size_t i = 0; i < skies_wanted; ++i)
    chosen.push_back(all[i * (all.size() - 1) / (skies_wanted - 1)]);
  return chosen;
}

RollFlight::RollFlight(const RollCase& the_case, const RollSky& sky, std::uint64_t seed,
                       std::size_t run)
    : case_(&the_case),
      sky_(&sky),
      gyro_noise_(stream_of(seed, run, "roll gyro")),
      power_noise_(stream_of(seed, run, "signal power")) {
  auto flight = stream_of(seed, run, "flight");
  azimuth_ = 2 * pi * flight.uniform();
  initial_roll_ = 2 * pi * flight.uniform();
  reference_ = frame::at_ned_offset(
      sky.place, reference_distance_m * Eigen::Vector3d{std::cos(azimuth_), std::sin(azimuth_), 0});
  auto gains = stream_of(seed, run, "gains");
  const double common = 1 + the_case.gain_sigma * gains.normal();
  for (std::size_t i = 0; i < sky.toward_ned.size(); ++i) {
    gains_.push_back(common * (1 + the_case.satellite_gain_sigma * gains.normal()));
    roll::Signal signal;
    signal.satellite = static_cast<std::uint16_t>(i);
    signal.toward_ned = sky.toward_ned[i];
    if (the_case.wire) {
      const auto& p = sky.toward_ned[i];
      signal.toward_ned = roll::toward_ned(rounded_to_degrees(std::asin(-p.z())),
                                           rounded_to_degrees(std::atan2(p.y(), p.x())));
    }
    signals_.push_back(signal);
  }
}

double RollFlight::true_roll(double t) const {
  const double swing = 2 * pi / rate_swing_period_s;
  return initial_roll_ +
         2 * pi * case_->roll_hz * (t + rate_swing / swing * (1 - std::cos(swing * t)));
}

roll::FlightPath RollFlight::path(double t) const {
  return {azimuth_, nose_over * (1 - 2 * t / roll_run_s)};
}

double RollFlight::gyro(double t) {
  constexpr double interval = 1 / roll_gyro_hz;
  return (true_roll(t) - true_roll(t - interval)) / interval +
         case_->gyro_white_degps * units::degree * gyro_noise_.normal();
}

std::span<const roll::Signal> RollFlight::signals(double t) {
  const auto way = path(t);
  const frame::Euler attitude{true_roll(t), way.pitch_rad, way.azimuth_rad};
  const Eigen::Matrix3d to_body = frame::ned_to_body(attitude);
  for (std::size_t i = 0; i < signals_.size(); ++i) {
    const double elevation =
        sky::antenna_elevation(to_body * sky_->toward_ned[i], Eigen::Vector3d::UnitZ());
    signals_[i].power = reported(gains_[i] * sky::antenna_power(elevation) +
                                 case_->power_noise * power_noise_.normal());
  }
  return signals_;
}

std::optional<double> RollFlight::reported(double power) {
  if (!case_->wire) return power;
  if (power < roll_tracking_limit) return std::nullopt;
  return std::pow(10, std::round(10 * std::log10(power)) / 10);
}

}  // namespace drydock::study
