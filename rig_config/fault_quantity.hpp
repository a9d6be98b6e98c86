#pragma once

#include <array>
#include <string_view>

#include "drivers/measurement/units.hpp"
#include "rig_config/rig.hpp"

/// The quantities that the sensors of each kind measure, with their keys in a fault and their
/// units.
namespace drydock::rig_config {

/// A key has the same unit for all kinds.
struct FaultQuantity {
  DeviceKind kind;
  std::string_view key;
  double unit;  ///< one unit of the key in SI
  bool secondary = false;
};

inline constexpr auto fault_quantities = std::to_array<FaultQuantity>({
    {DeviceKind::dvl, "velocity_mps", 1},
    {DeviceKind::emlog, "speed_mps", 1},
    {DeviceKind::gnss, "position_m", 1},
    {DeviceKind::gnss, "velocity_mps", 1, true},
    {DeviceKind::imu, "rate_degps", units::degree},
    {DeviceKind::imu, "specific_force_mps2", 1, true},
    {DeviceKind::depth, "pressure_pa", 1},
    {DeviceKind::actuator, "angle_deg", units::degree},
    {DeviceKind::actuator, "shaft_rpm", units::revolution_per_minute, true},
    {DeviceKind::attitude, "attitude_deg", units::degree},
    {DeviceKind::attitude, "turn_degps", units::degree, true},
});

/// True if the key names the second quantity of a sensor: specific force, GNSS velocity, shaft.
constexpr bool is_secondary(DeviceKind kind, std::string_view key) {
  for (const FaultQuantity& quantity : fault_quantities)
    if (quantity.kind == kind && quantity.key == key) return quantity.secondary;
  return false;
}

}  // namespace drydock::rig_config
