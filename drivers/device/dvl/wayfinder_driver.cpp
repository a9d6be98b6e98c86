#include "drivers/device/dvl/wayfinder_driver.hpp"

#include <utility>

namespace drydock::device {
namespace {

/// The fourth component is another beam or the error velocity, which turns with the others.
wire::DvlComponents turned(wire::DvlComponents velocity_mps) {
  for (auto& component : velocity_mps)
    if (component) component = -*component;
  return velocity_mps;
}

}  // namespace

void WayfinderDriver::on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) {
  const auto message = wire::Wayfinder::decode(frame);
  const auto* ping = message ? std::get_if<wire::WayfinderPing>(&*message) : nullptr;
  if (!ping) return;
  measurement::BottomVelocity result;
  result.origin = timing_.of_bytes(arrival);
  if (ping->clock) result.origin.device_time = *ping->clock;
  result.velocity = velocity_of(*ping, out);
  if (ping->frame && *ping->frame != wire::DvlFrame::beam)
    result.error_velocity_mps = ping->velocity_mps[3];
  result.range_m = ping->range_m;
  result.sound_speed_mps = ping->sound_speed_mps;
  finish_.publish(result, {}, out);
}

std::optional<Eigen::Vector3d> WayfinderDriver::velocity_of(const wire::WayfinderPing& ping,
                                                            Output& out) {
  if (!ping.frame) return {};
  wire::DvlGeometry geometry;
  geometry.beam_angle_rad = wire::wayfinder::beam_angle_rad;
  geometry.frame = *ping.frame;
  const auto sent = of_bed_.value_or(false) ? turned(ping.velocity_mps) : ping.velocity_mps;
  auto velocity = solution_.velocity(sent, geometry, {}, out);
  if (velocity) say_sign(out);
  return velocity;
}

void WayfinderDriver::say_sign(Output& out) {
  if (of_bed_ || std::exchange(sign_said_, true)) return;
  out.report(
      "the velocity is taken as the vehicle's, because no document tells its sign: drive ahead to "
      "see it, then set velocity_of to vehicle or bed");
}

}  // namespace drydock::device
