#include <fmt/format.h>

#include "drivers/measurement/actuator_order.hpp"
#include "rig_config/checks/checks.hpp"
#include "rig_config/steering.hpp"

namespace drydock::rig_config {

namespace {

using measurement::first_thruster_number;

Problem problem_at(const Node& node, const std::string& file, std::string path,
                   std::string message) {
  return {file, node.at.line, node.at.column, std::move(path), std::move(message)};
}

/// Why the drive with this number cannot move that vehicle. Empty: it can.
std::string refusal_of(int number, const ThrusterVehicleConfig& vehicle) {
  const int last = first_thruster_number + static_cast<int>(vehicle.thrusters.size()) - 1;
  if (number < first_thruster_number || number > last)
    return fmt::format("vehicle {} has thrusters alone, allowed: {} to {}", vehicle.name,
                       first_thruster_number, last);
  const auto& thruster =
      vehicle.thrusters[static_cast<std::size_t>(number - first_thruster_number)];
  if (thruster.limit_radps > 0) return {};
  return fmt::format(
      "thruster {} of vehicle {} has no limit_rpm in the vehicle file, by which a "
      "drive turns it",
      thruster.name, vehicle.name);
}

}  // namespace

Problems check_steering(const Node& root, const std::string& file, const MissionConfig& mission) {
  const Node& table = *root.find("mission");
  if (!mission.thruster_vehicle) {
    if (steered_over_wires(mission) && !table.find("speed_mps"))
      return {problem_at(table, file, "/mission", "key 'speed_mps' is missing")};
    return {};
  }
  if (!mission.steering || has_plan(mission))
    return {problem_at(*table.find("vehicle"), file, "/mission/vehicle",
                       "a vehicle with thrusters cannot sail legs by itself: allowed with "
                       "[steering], in which another program steers it, and without legs")};
  if (mission.speed_mps != 0)
    return {problem_at(*table.find("speed_mps"), file, "/mission/speed_mps",
                       "a vehicle with thrusters begins at rest, allowed: 0")};
  return {};
}

Problems check_drives(const Node& root, const std::string& file, const Rig& rig) {
  Problems problems;
  const auto& thrusters = rig.mission.thruster_vehicle;
  for_each_table(root, "device", [&](const Node& table, std::size_t i) {
    const DeviceConfig& device = rig.devices[i];
    if (device.kind != DeviceKind::actuator) return;
    const auto refuse = [&](const char* key, std::string message) {
      problems.push_back(problem_at(*table.find(key), file, fmt::format("/device/{}/{}", i, key),
                                    std::move(message)));
    };
    if (thrusters && device.protocol == "nmea2000")
      refuse("protocol", fmt::format("on NMEA 2000 nothing moves the thrusters of vehicle {}, "
                                     "allowed: cia402",
                                     thrusters->name));
    if (device.protocol != "cia402") return;
    const int number = *device.instance;
    if (thrusters) {
      if (auto why = refusal_of(number, *thrusters); !why.empty()) refuse("instance", why);
    } else if (number >= first_thruster_number) {
      refuse("instance", "the vehicle of the mission has no thrusters, allowed: 0 to 3");
    }
  });
  return problems;
}

}  // namespace drydock::rig_config
