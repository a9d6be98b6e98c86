#pragma once

#include "estimators/hydrodynamics/model.hpp"
#include "estimators/vehicle/vehicle.hpp"
#include "rig_config/load.hpp"

namespace drydock::velocity::test {

inline hydrodynamics::Vehicle nps_vehicle(const std::string& name = "nps-auv-ii") {
  return vehicle::dimensional(
      rig_config::load_vehicle(DRYDOCK_SOURCE_DIR "/rig_config/vehicles/" + name + ".toml")
          .value());
}

}  // namespace drydock::velocity::test
