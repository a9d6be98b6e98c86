#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

/// A vehicle file as typed values, SI. The names are those of the TOML keys. The JSON Schema
/// `rig_config/schema/vehicle.schema.json` defines the allowed values.
namespace drydock::rig_config {

/// One coefficient of the Gertler-Hagen equations, as in the file.
struct CoefficientConfig {
  std::string axis, name;  ///< "Y", "v|r|"
  double prime = 0;        ///< prime value; times rho/2 L^n gives the SI value
};

/// A rudder or a pair of planes.
struct SurfaceConfig {
  double limit_rad = 0;                    ///< to both sides
  std::optional<double> rate_limit_radps;  ///< empty: only the lag limits the rate
  double lag_s = 0;                        ///< time constant
};

struct PropellerConfig {
  double advance_m = 0;    ///< commanded speed = advance_m times rate of rotation in rad/s
  double limit_radps = 0;  ///< ahead; the propeller does not turn astern
  std::optional<double> rate_limit_radps2;
  double lag_s = 0;
};

struct VehicleConfig {
  std::string name;
  double length_m = 0, water_density_kgm3 = 0;  ///< for the prime values
  double mass_kg = 0, weight_n = 0, buoyancy_n = 0;
  double z_G_m = 0, z_B_m = 0;  ///< positive below the origin of the body axes
  std::array<double, 3> moments_of_inertia_kgm2{};
  SurfaceConfig rudder, stern_planes, bow_planes;
  PropellerConfig propeller;
  std::vector<CoefficientConfig> coefficients;  ///< in file order; missing coefficients are 0
};

}  // namespace drydock::rig_config
