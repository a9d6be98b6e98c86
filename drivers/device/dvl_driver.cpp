#include "drivers/device/dvl_driver.hpp"

#include <cmath>

#include "drivers/wire/pd0_velocity.hpp"

namespace drydock::device {

namespace {

using Ranges = std::array<std::optional<double>, 4>;

/// Height over a flat bed. With u the slant of a beam, its vertical component is d = h cos(b) /
/// (n.u), n the down vector in instrument axes. In a Janus pair the tilt terms of 1/d cancel: 1/d1
/// + 1/d2 = 2 n_z / h, so h is n_z = cos(pitch) cos(roll) times the harmonic mean.
std::optional<double> altitude(const Ranges& range_m, const wire::Pd0VariableLeader& tilt) {
  if (!tilt.pitch_rad || !tilt.roll_rad) return {};
  double inverse_sum = 0;
  int beams = 0;
  for (const std::size_t first : {0U, 2U}) {  // beams 1 and 2 face each other, 3 and 4 too
    if (!range_m[first] || !range_m[first + 1]) continue;
    inverse_sum += 1 / *range_m[first] + 1 / *range_m[first + 1];
    beams += 2;
  }
  if (beams == 0) return {};
  // The pitch sensor reads the tilt of the bow axis (see pd0_velocity.hpp).
  const double pitch = std::atan(std::tan(*tilt.pitch_rad) * std::cos(*tilt.roll_rad));
  return std::cos(pitch) * std::cos(*tilt.roll_rad) * beams / inverse_sum;
}

}  // namespace

void DvlDriver::receive(wire::Bytes bytes, Stamp received_at, Output& out) {
  framer_.feed(bytes, wire::Pd0::scan, [&](wire::Bytes frame, std::size_t after) {
    const auto message = wire::Pd0::decode(frame);
    if (!message) return;
    const auto& ensemble = std::get<wire::Pd0Ensemble>(*message);
    const auto age = ensemble.navigation ? age_of(*ensemble.navigation) : std::nullopt;
    on(ensemble,
       age ? timing_.of_bytes(received_at, frame.size(), after, *age)
           : timing_.of_bytes(received_at, frame.size(), after),
       out);
  });
}

void DvlDriver::on(const wire::Pd0Ensemble& ensemble, const Origin& origin, Output& out) const {
  if (!ensemble.bottom_track && !ensemble.high_resolution) return;
  const wire::Pd0VariableLeader& leader = ensemble.variable;

  measurement::BottomVelocity result;
  result.origin = origin;
  if (leader.clock) result.origin.device_time = leader.clock->time_since_epoch();
  if (const auto v = wire::velocity_frd(ensemble)) {
    result.velocity = mounting_.to_body({(*v)[0], (*v)[1], (*v)[2]});
  }
  if (ensemble.fixed.frame != wire::Pd0Frame::beam) {
    result.error_velocity_mps = wire::finest_velocity(ensemble)[3];
  }
  if (!ensemble.fixed.faces_up) {
    if (ensemble.bottom_track) result.range_m = ensemble.bottom_track->range_m;
    if (ensemble.bottom_range) result.altitude_m = ensemble.bottom_range->vertical_range_m;
    if (!result.altitude_m) result.altitude_m = altitude(result.range_m, leader);
  }
  result.heading_rad = leader.heading_rad;
  result.pitch_rad = leader.pitch_rad;
  result.roll_rad = leader.roll_rad;
  result.sound_speed_mps = leader.sound_speed_mps;
  out.publish(result);
}

}  // namespace drydock::device
