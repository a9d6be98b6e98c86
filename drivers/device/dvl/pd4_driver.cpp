#include "drivers/device/dvl/pd4_driver.hpp"

#include <algorithm>

namespace drydock::device {

namespace {

wire::DvlAttitude attitude_of(const wire::Pd4Report&) { return {}; }
wire::DvlAttitude attitude_of(const wire::Pd5Report& report) { return report; }

WaterAtHead water_of(const wire::Pd4Report& report) { return {report.temperature_k, {}}; }
WaterAtHead water_of(const wire::Pd5Report& report) {
  return {report.temperature_k, report.depth_m, report.salinity_ppt};
}

}  // namespace

template <class Protocol>
void Pd4Driver<Protocol>::on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) {
  const auto message = Protocol::decode(frame);
  if (!message) return;
  publish(std::get<typename Protocol::Report>(*message), this->timing_.of_bytes(arrival), out);
}

template <class Protocol>
void Pd4Driver<Protocol>::publish(const typename Protocol::Report& report, const Origin& origin,
                                  Output& out) {
  const wire::DvlAttitude attitude = attitude_of(report);
  measurement::BottomVelocity result;
  result.origin = origin;
  result.origin.device_time = report.first_ping;
  // Makers send different values without lock. Without any range there is no lock.
  if (std::ranges::any_of(report.bottom_range_m, [](const auto& range) { return !!range; })) {
    result.velocity = solution_.velocity(report.bottom_velocity_mps, report, attitude, out);
  }
  if (report.frame != wire::DvlFrame::beam) {
    result.error_velocity_mps = report.bottom_velocity_mps[3];
  }
  result.range_m = report.bottom_range_m;
  result.altitude_m = altitude_over_bed(report.bottom_range_m, attitude);
  result.heading_rad = attitude.heading_rad;
  result.pitch_rad = attitude.pitch_rad;
  result.roll_rad = attitude.roll_rad;
  result.sound_speed_mps = report.sound_speed_mps;
  finish_.publish(result, water_of(report), out);
}

template class Pd4Driver<wire::Pd4>;
template class Pd4Driver<wire::Pd5>;

}  // namespace drydock::device
