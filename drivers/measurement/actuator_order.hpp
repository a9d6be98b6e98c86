#pragma once

#include <optional>

namespace drydock::measurement {

/// What the actuators are told. Signs are those of ActuatorState; an empty value leaves that
/// actuator alone.
struct ActuatorOrder {
  std::optional<double> rudder_rad{};       ///< turns to port if positive
  std::optional<double> stern_plane_rad{};  ///< nose down if positive
  std::optional<double> bow_plane_rad{};
  std::optional<double> propeller_radps{};
};

/// The four values by their number on the wires: rudder, stern planes, bow planes, propeller. From
/// 4 on the numbers are those of thrusters, whose shaft is a propeller.
inline constexpr int propeller_number = 3, actuator_count = 4;
inline constexpr int first_thruster_number = actuator_count;

template <class Order>
constexpr auto& value_of(Order& order, int number) {
  switch (number) {
    case 0: return order.rudder_rad;
    case 1: return order.stern_plane_rad;
    case 2: return order.bow_plane_rad;
    default: return order.propeller_radps;
  }
}

}  // namespace drydock::measurement
