#include "hil/track/attitudes.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "drivers/measurement/head_tilt.hpp"
#include "estimators/frame/mounted.hpp"

namespace drydock::track {
namespace {

/// A device that told its tilts for this part of the longest time told them as long.
constexpr double about_as_long = 0.9;

Eigen::Matrix3d sensor_to_body(const rig_config::DeviceConfig& device) {
  const auto [roll, pitch, yaw] = device.mounting_rad;
  return frame::ned_to_body({roll, pitch, yaw}).transpose();
}

double length_of(const std::vector<smoothing::Tilt>& tilts) {
  const auto [first, last] = std::ranges::minmax_element(tilts, {}, &smoothing::Tilt::time_s);
  return last->time_s - first->time_s;
}

}  // namespace

void Attitudes::hear(double time_s, const measurement::BottomVelocity& track) {
  const auto device = track.origin.device;
  if (device >= rig_.devices.size()) return;
  const auto own = measurement::head_tilt(track);
  smoothing::Tilt tilt{time_s};
  if (own) {
    const auto body =
        frame::of_body({own->roll_rad, own->pitch_rad, 0}, sensor_to_body(rig_.devices[device]));
    tilt = {time_s, body.roll, body.pitch};
    tilts_[device].push_back(tilt);
  }
  if (track.heading_rad && std::isfinite(*track.heading_rad))
    heads_.push_back({time_s, track.origin, *track.heading_rad, own.has_value(), tilt});
}

void Attitudes::hear(double time_s, const measurement::AttitudeSample& sample) {
  if (!sample.roll_rad || !sample.pitch_rad) return;
  if (!std::isfinite(*sample.roll_rad) || !std::isfinite(*sample.pitch_rad)) return;
  tilts_[sample.origin.device].push_back({time_s, *sample.roll_rad, *sample.pitch_rad});
}

Attitudes::Tilts Attitudes::tilts() const {
  const auto is_dvl = [&](std::uint16_t device) {
    return device < rig_.devices.size() && rig_.devices[device].kind == measurement::Kind::dvl;
  };
  double longest_s = 0;
  for (const auto& [device, tilts] : tilts_) longest_s = std::max(longest_s, length_of(tilts));
  const auto worth = [&](const auto& of_device) {
    const auto& [device, tilts] = of_device;
    return std::tuple(length_of(tilts) >= about_as_long * longest_s, !is_dvl(device), tilts.size());
  };
  const auto best = std::ranges::max_element(tilts_, {}, worth);
  if (best == tilts_.end()) return {};
  Tilts found{best->second, is_dvl(best->first)};
  std::ranges::stable_sort(found.all, {}, &smoothing::Tilt::time_s);
  return found;
}

std::vector<Attitudes::Heading> Attitudes::of_heads(
    const std::vector<smoothing::Tilt>& tilts) const {
  std::vector<Heading> headings;
  for (const Head& head : heads_) {
    const auto tilt = head.has_tilt ? head.tilt : smoothing::tilt_at(tilts, head.time_s);
    const double turn =
        frame::heading_beside_sensor(frame::down_in_body(tilt.roll_rad, tilt.pitch_rad),
                                     sensor_to_body(rig_.devices[head.origin.device]));
    headings.push_back({head.origin, frame::wrap_pi(head.heading_rad + turn)});
  }
  return headings;
}

}  // namespace drydock::track
