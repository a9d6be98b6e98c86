#include "drivers/device/dvl/dvl_driver.hpp"

#include "drivers/wire/dvl/pd0_velocity.hpp"

namespace drydock::device {

void DvlDriver::on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) {
  const auto message = wire::Pd0::decode(frame);
  if (!message) return;
  const auto& ensemble = std::get<wire::Pd0Ensemble>(*message);
  const auto age = ensemble.navigation ? age_of(*ensemble.navigation) : std::nullopt;
  on(ensemble, age ? timing_.of_bytes(arrival, *age) : timing_.of_bytes(arrival), out);
}

void DvlDriver::on(const wire::Pd0Ensemble& ensemble, const Origin& origin, Output& out) {
  if (!ensemble.bottom_track && !ensemble.high_resolution) return;
  const wire::Pd0VariableLeader& leader = ensemble.variable;

  measurement::BottomVelocity result;
  result.origin = origin;
  if (leader.clock) result.origin.device_time = leader.clock->time_since_epoch();
  const wire::DvlComponents velocity = wire::finest_velocity(ensemble);
  result.velocity = solution_.velocity(velocity, ensemble.fixed, leader, out);
  result.error_velocity_mps = wire::error_velocity(velocity, ensemble.fixed);
  if (wire::is_of_the_bed(ensemble.fixed)) {
    if (ensemble.bottom_track) result.range_m = ensemble.bottom_track->range_m;
    if (ensemble.bottom_range) result.altitude_m = ensemble.bottom_range->vertical_range_m;
    if (!result.altitude_m) result.altitude_m = altitude_over_bed(result.range_m, leader);
  }
  result.heading_rad = leader.heading_rad;
  result.pitch_rad = leader.pitch_rad;
  result.roll_rad = leader.roll_rad;
  result.sound_speed_mps = leader.sound_speed_mps;
  finish_.publish(result, {leader.temperature_k, leader.depth_m, leader.salinity_ppt}, out);
}

}  // namespace drydock::device
