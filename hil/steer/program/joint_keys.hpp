#pragma once

#include <string_view>

#include "drivers/measurement/units.hpp"
#include "hil/steer/joint.hpp"

namespace drydock::steer {

/// The key of an order that a joint obeys, and the factor from its unit to that of the order.
struct JointKey {
  std::string_view key;
  double unit = 1;
};

constexpr JointKey key_of(JointKind kind) {
  switch (kind) {
    case JointKind::surface: return {"position_deg", units::degree};
    case JointKind::propeller: return {"velocity_radps", 1};
    case JointKind::thruster: return {"effort_n", 1};
  }
  return {};
}

}  // namespace drydock::steer
