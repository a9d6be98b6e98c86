#include <fmt/format.h>

#include <algorithm>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/attitude.hpp"
#include "hil/calibrate/device_block.hpp"
#include "hil/calibrate/outcome.hpp"

namespace drydock::calibrate {
namespace {

using calibration::Finding;
using calibration::Unknown;
using calibration::Verdict;

/// What was told of one device, as changes.
struct Change {
  double yaw = 0, pitch = 0, scale = 0, latency_s = 0;
  Eigen::Vector3d lever = Eigen::Vector3d::Zero();
  Eigen::Vector3d compass_error = Eigen::Vector3d::Zero();  ///< constant, sine, cosine
  bool turned = false, scaled = false, delayed = false, moved = false, deviates = false;
};

void take(const Finding& f, Change& change) {
  switch (f.parameter.unknown) {
    case Unknown::yaw: change.yaw = f.value, change.turned = true; break;
    case Unknown::pitch: change.pitch = f.value, change.turned = true; break;
    case Unknown::scale: change.scale = f.value, change.scaled = true; break;
    case Unknown::latency: change.latency_s = f.value, change.delayed = true; break;
    case Unknown::lever_ahead: change.lever.x() = f.value, change.moved = true; break;
    case Unknown::lever_starboard: change.lever.y() = f.value, change.moved = true; break;
    case Unknown::deviation_constant:
      change.compass_error[0] = f.value, change.deviates = true;
      break;
    case Unknown::deviation_sine: change.compass_error[1] = f.value, change.deviates = true; break;
    case Unknown::deviation_cosine:
      change.compass_error[2] = f.value, change.deviates = true;
      break;
  }
}

/// A DVL that gives the heading has no key for the error of its compass.
bool has_no_key(const Finding& f, const rig_config::DeviceConfig& device) {
  return f.parameter.unknown >= Unknown::deviation_constant &&
         device.kind != measurement::Kind::attitude;
}

std::string triple(const Eigen::Vector3d& v, int digits) {
  return fmt::format("[{:.{}f}, {:.{}f}, {:.{}f}]", v.x(), digits, v.y(), digits, v.z(), digits);
}

/// The sensor's axes in the body: what was found, behind the turn that the rig has.
std::string mounting(const rig_config::DeviceConfig& device, const Change& change) {
  const auto [roll, pitch, yaw] = device.mounting_rad;
  const auto angles = frame::euler(frame::body_to_ned({0, change.pitch, change.yaw}) *
                                   frame::body_to_ned({roll, pitch, yaw}));
  return triple(units::degrees_per_radian * Eigen::Vector3d{angles.roll, angles.pitch, angles.yaw},
                3);
}

std::string compass_error(const rig_config::DeviceConfig& device, const Change& change) {
  return triple(units::degrees_per_radian *
                    (Eigen::Vector3d{device.compass_error_rad.data()} + change.compass_error),
                3);
}

std::string sound_speed(double used_mps, const Change& change) {
  return fmt::format("{{ source = \"fixed\", mps = {:.2f} }}", used_mps / (1 + change.scale));
}

std::string with_change(std::string rig, const track::Gathered& gathered, std::uint16_t index,
                        const Change& change) {
  const auto& device = gathered.rig.devices[index];
  if (change.turned) rig = with_key(rig, device.name, "mounting_deg", mounting(device, change));
  if (change.moved)
    rig = with_key(rig, device.name, "lever_arm_m",
                   triple(Eigen::Vector3d{device.lever_arm_m.data()} + change.lever, 3));
  if (change.delayed)
    rig = with_key(rig, device.name, "latency_ms",
                   fmt::format("{:.1f}", 1e3 * std::max(0.0, device.latency_s + change.latency_s)));
  if (change.deviates && device.kind == measurement::Kind::attitude)
    rig = with_key(rig, device.name, "compass_error_deg", compass_error(device, change));
  if (change.scaled && device.kind == measurement::Kind::emlog)
    rig = with_key(rig, device.name, "speed_scale",
                   fmt::format("{:.4f}", device.speed_scale * (1 + change.scale)));
  if (const auto used = gathered.sound_speed_mps.find(index);
      change.scaled && used != gathered.sound_speed_mps.end())
    rig = with_key(rig, device.name, "sound_speed", sound_speed(used->second, change));
  return rig;
}

}  // namespace

std::string calibrated_rig(const Outcome& outcome, std::vector<std::string>& notes) {
  const auto& gathered = outcome.gathered;
  std::map<std::uint16_t, Change> changes;
  for (const auto& finding : outcome.calibration.findings) {
    if (finding.verdict != Verdict::told) continue;
    const auto& device = gathered.rig.devices.at(finding.parameter.device);
    if (gathered.own_heading && finding.parameter.unknown == Unknown::yaw) continue;
    if (gathered.own_tilts && finding.parameter.unknown == Unknown::pitch) continue;
    if (has_no_key(finding, device))
      notes.push_back(fmt::format("{}: {} has no key in a rig file", device.name,
                                  name_of(finding.parameter.unknown)));
    take(finding, changes[finding.parameter.device]);
  }
  std::string rig = gathered.rig_text;
  for (const auto& [index, change] : changes) {
    const bool is_dvl = gathered.rig.devices[index].kind == measurement::Kind::dvl;
    rig = with_change(std::move(rig), gathered, index, change);
    if (is_dvl && change.scaled && !gathered.sound_speed_mps.contains(index))
      notes.push_back(gathered.rig.devices[index].name +
                      ": it does not say its speed of sound, so the scale is not written");
  }
  return rig;
}

}  // namespace drydock::calibrate
