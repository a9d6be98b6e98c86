#pragma once

#include <array>
#include <string>
#include <vector>

/// A vehicle file of a vehicle with thrusters as typed values, SI. The names are those of the TOML
/// keys. Arrays of six are surge, sway, heave, roll, pitch, yaw, body axes.
namespace drydock::rig_config {

struct ThrusterConfig {
  std::string name;
  std::array<double, 3> position_m{};  ///< in the body frame
  std::array<double, 3> direction{};   ///< of the push for a positive command; any length
  double ahead_n = 0, astern_n = 0;    ///< push at full command, both positive
  double exponent = 1;     ///< push = full push times (command beyond dead band)^exponent
  double dead_band = 0;    ///< share of the full command without a push
  double lag_s = 0;        ///< time constant
  double limit_radps = 0;  ///< of the shaft at full command, in proportion to it; 0: not known
};

struct ThrusterVehicleConfig {
  std::string name;
  double mass_kg = 0, weight_n = 0, buoyancy_n = 0;
  double z_G_m = 0, z_B_m = 0;  ///< positive below the origin of the body axes
  std::array<double, 3> moments_of_inertia_kgm2{};
  std::array<double, 6> added_mass{};         ///< kg, kg m2; positive
  std::array<double, 6> linear_damping{};     ///< N s/m, N m s; positive
  std::array<double, 6> quadratic_damping{};  ///< N s2/m2, N m s2; positive
  std::vector<ThrusterConfig> thrusters;      ///< in the order of the outputs that drive them
};

}  // namespace drydock::rig_config
