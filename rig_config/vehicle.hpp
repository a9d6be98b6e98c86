#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

/// A vehicle file as typed values, SI. Names are those of the TOML keys; the JSON Schema
/// `rig_config/schema/vehicle.schema.json` says which are allowed.
namespace drydock::rig_config {

/// One coefficient of the Gertler-Hagen equations as written in the file.
struct CoefficientConfig {
  std::string axis, name;  ///< "Y", "v|r|"
  double prime = 0;        ///< of the prime system: to be multiplied by rho/2 L^n
};

/// A rudder or a pair of planes.
struct SurfaceConfig {
  double limit_rad = 0;                    ///< to both sides
  std::optional<double> rate_limit_radps;  ///< none: as fast as the lag lets it
  double lag_s = 0;                        ///< time constant
};

struct PropellerConfig {
  double advance_m = 0;    ///< commanded speed = advance times rate of turn in rad/s
  double limit_radps = 0;  ///< ahead; it does not turn astern
  std::optional<double> rate_limit_radps2;
  double lag_s = 0;
};

struct VehicleConfig {
  std::string name;
  double length_m = 0, water_density_kgm3 = 0;  ///< of the prime system
  double mass_kg = 0, weight_n = 0, buoyancy_n = 0;
  double z_G_m = 0, z_B_m = 0;  ///< positive below the origin of the body axes
  std::array<double, 3> moments_of_inertia_kgm2{};
  SurfaceConfig rudder, stern_planes, bow_planes;
  PropellerConfig propeller;
  std::vector<CoefficientConfig> coefficients;  ///< in file order; what is not here is 0
};

}  // namespace drydock::rig_config
