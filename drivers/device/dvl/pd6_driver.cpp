#include "drivers/device/dvl/pd6_driver.hpp"

namespace drydock::device {

void Pd6Driver::restart(Stamp now, Output& out) {
  StreamDriver::restart(now, out);
  epoch_.restart();
}

void Pd6Driver::on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) {
  const auto line = wire::Pd6::decode(frame);
  if (!line) return;
  const auto step =
      epoch_.take(*line, {timing_.of_bytes(arrival), timing_.line_time(frame.size()),
                          timing_.line_time(arrival.skipped), counters().bad_checksums});
  if (step == Pd6Epoch::Step::complete) publish(out);
  if (step == Pd6Epoch::Step::broken) {
    out.report(
        "an ensemble was left out: a line was lost, damaged or not in the order SA TS WI WS WE WD "
        "BI BS BE BD");
  }
}

void Pd6Driver::publish(Output& out) {
  const Pd6Epoch::Lines& lines = epoch_.lines();
  wire::DvlGeometry geometry;
  geometry.frame = lines.instrument.good || !lines.earth.good ? wire::DvlFrame::instrument
                                                              : wire::DvlFrame::earth;
  const wire::DvlComponents& velocity = geometry.frame == wire::DvlFrame::instrument
                                            ? lines.instrument.velocity_mps
                                            : lines.earth.velocity_mps;
  measurement::BottomVelocity result;
  result.origin = epoch_.origin();
  if (lines.timing.clock) result.origin.device_time = lines.timing.clock->time_since_epoch();
  result.velocity = solution_.velocity(velocity, geometry, lines.attitude, out);
  result.error_velocity_mps = velocity[3];
  if (result.velocity) result.altitude_m = lines.distance.range_m;
  result.heading_rad = lines.attitude.heading_rad;
  result.pitch_rad = lines.attitude.pitch_rad;
  result.roll_rad = lines.attitude.roll_rad;
  result.sound_speed_mps = lines.timing.sound_speed_mps;
  finish_.publish(
      result, {lines.timing.temperature_k, lines.timing.depth_m, lines.timing.salinity_ppt}, out);
}

}  // namespace drydock::device
