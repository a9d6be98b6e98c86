#include "hil/motion/vehicle/keep_in_water.hpp"

#include <algorithm>

#include "hil/motion/vehicle/contact.hpp"

namespace drydock::motion {

void keep_in_water(VehicleState& state, const ocean::Ocean& ocean) {
  constexpr double give_m = 0.1;
  const double bed_m = ocean.bed_depth_m(state.latitude_rad, state.longitude_rad);
  const bool too_high = state.height_m > highest_m + give_m,
             too_low = -state.height_m > bed_m + give_m;
  if (!too_high && !too_low) return;
  state.height_m = too_high ? highest_m : -bed_m;
  Eigen::Vector3d through_water = state.body_to_ned * state.velocity.head<3>();
  through_water.z() =
      too_high ? std::max(through_water.z(), 0.0) : std::min(through_water.z(), 0.0);
  state.velocity.head<3>() = state.body_to_ned.conjugate() * through_water;
}

}  // namespace drydock::motion
