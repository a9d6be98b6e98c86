#include "estimators/consistency/tracks.hpp"

#include <cmath>
#include <numbers>

#include "drivers/measurement/head_tilt.hpp"
#include "estimators/frame/earth.hpp"
#include "estimators/frame/mounted.hpp"

namespace drydock::consistency {
namespace {

/// Two missing samples in a row are an outage.
std::chrono::nanoseconds gap_of(const Sensor& sensor) {
  return measurement::from_seconds(std::max(0.25, 3.1 / std::max(sensor.rate_hz, 0.1)));
}

Eigen::Matrix<double, 1, 1> scalar(double value) { return Eigen::Matrix<double, 1, 1>{value}; }

/// North and east of a short way at a height: dN = (R_N + h) dphi, dE = (R_E + h) cos(phi) dlambda.
Eigen::Vector2d way(const measurement::Geodetic& from, const measurement::Geodetic& to,
                    double height_m) {
  const double latitude = (from.latitude_rad + to.latitude_rad) / 2;
  const double east = std::remainder(to.longitude_rad - from.longitude_rad, 2 * std::numbers::pi);
  return {(frame::meridian_radius(latitude) + height_m) * (to.latitude_rad - from.latitude_rad),
          (frame::transverse_radius(latitude) + height_m) * std::cos(latitude) * east};
}

}  // namespace

double Unwrapped::next(double angle_rad) {
  return last_ += std::remainder(angle_rad - last_, 2 * std::numbers::pi);
}

DvlTracks::DvlTracks(std::uint16_t index, const Sensor& s)
    : device(index),
      sensor(s),
      velocity(gap_of(s)),
      heading(gap_of(s)),
      down(gap_of(s)),
      depth(gap_of(s)) {}
LogTracks::LogTracks(std::uint16_t index, const Sensor& s)
    : device(index), sensor(s), speed(gap_of(s)) {}
GnssTracks::GnssTracks(std::uint16_t index, const Sensor& s)
    : device(index), sensor(s), velocity(gap_of(s)), place(gap_of(s)) {}
DepthTracks::DepthTracks(std::uint16_t index, const Sensor& s)
    : device(index), sensor(s), depth(gap_of(s)) {}
ActuatorTracks::ActuatorTracks(std::uint16_t index, const Sensor& s)
    : device(index), of_thruster(s.of_thruster), rudder(gap_of(s)), shaft(gap_of(s)) {}
AttitudeTracks::AttitudeTracks(std::uint16_t index, const Sensor& s)
    : device(index), heading(gap_of(s)), tilt(gap_of(s)), turn(gap_of(s)) {}

void take(DvlTracks& tracks, const measurement::BottomVelocity& sample) {
  const Stamp at = sample.origin.valid_at;
  if (sample.velocity) tracks.velocity.push(at, *sample.velocity);
  if (sample.heading_rad)
    tracks.heading.push(at, scalar(tracks.unwrapped.next(*sample.heading_rad)));
  if (const auto tilt = measurement::head_tilt(sample))
    tracks.down.push(
        at, tracks.sensor.sensor_to_body * frame::down_in_body(tilt->roll_rad, tilt->pitch_rad));
  if (!sample.depth_m) return;
  tracks.depth.push(at, scalar(*sample.depth_m));
  if (tracks.told_depth_m && *tracks.told_depth_m != *sample.depth_m) tracks.depth_changed = at;
  tracks.told_depth_m = sample.depth_m;
}

std::optional<double> DvlTracks::living_depth(Stamp at) const {
  constexpr std::chrono::minutes asleep{2};
  const auto read = depth.at(at);
  if (!read || depth_changed == Stamp{} || at - depth_changed > asleep) return {};
  return read->value.x();
}

void take(LogTracks& tracks, const measurement::WaterSpeed& sample) {
  tracks.across = sample.transverse_mps.has_value();
  if (sample.longitudinal_mps)
    tracks.speed.push(sample.origin.valid_at,
                      {*sample.longitudinal_mps, sample.transverse_mps.value_or(0)});
}

void take(GnssTracks& tracks, const measurement::GnssFix& fix) {
  const Stamp at = fix.origin.valid_at;
  if (fix.velocity_ned)
    tracks.velocity.push(at, fix.velocity_ned->head<2>());
  else if (fix.ground_speed_mps && fix.course_rad)
    tracks.velocity.push(at, *fix.ground_speed_mps * Eigen::Vector2d{std::cos(*fix.course_rad),
                                                                     std::sin(*fix.course_rad)});
  if (fix.velocity_ned)
    tracks.speed_mps = fix.velocity_ned->norm();
  else if (fix.ground_speed_mps)
    tracks.speed_mps = *fix.ground_speed_mps;
  if (!fix.position) return;
  const double height_m =
      fix.ellipsoidal_height_m.value_or(fix.mean_sea_level_height_m.value_or(0));
  if (tracks.last) tracks.moved_m += way(*tracks.last, *fix.position, height_m);
  tracks.last = fix.position;
  tracks.place.push(at, tracks.moved_m);
}

void take(DepthTracks& tracks, const measurement::DepthSample& sample) {
  if (sample.depth_m) tracks.depth.push(sample.origin.valid_at, scalar(*sample.depth_m));
}

void take(ActuatorTracks& tracks, const measurement::ActuatorState& state) {
  if (state.rudder_rad) tracks.rudder.push(state.origin.valid_at, scalar(*state.rudder_rad));
  if (state.propeller_radps && !tracks.of_thruster)
    tracks.shaft.push(state.origin.valid_at, scalar(*state.propeller_radps));
}

void take(AttitudeTracks& tracks, const measurement::AttitudeSample& sample) {
  const Stamp at = sample.origin.valid_at;
  const auto heading = sample.true_heading_rad ? sample.true_heading_rad : sample.heading_rad;
  if (heading) tracks.heading.push(at, scalar(tracks.unwrapped.next(*heading)));
  if (sample.roll_rad && sample.pitch_rad)
    tracks.tilt.push(at, {*sample.roll_rad, *sample.pitch_rad});
  if (sample.rate_of_turn_radps) tracks.turn.push(at, scalar(*sample.rate_of_turn_radps));
}

}  // namespace drydock::consistency
