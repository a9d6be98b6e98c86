#include "hil/emulate/dvl_head.hpp"

#include <cmath>
#include <numbers>

namespace drydock::emulate {

wire::DvlAttitude head_attitude(const measurement::BottomVelocity& measured) {
  const double heading = *measured.heading_rad;
  return {heading < 0 ? heading + 2 * std::numbers::pi : heading,
          std::atan(std::tan(*measured.pitch_rad) / std::cos(*measured.roll_rad)),
          measured.roll_rad};
}

wire::DvlComponents along_head_axes(const Eigen::Vector3d& frd, double error_mps) {
  return {frd.y(), frd.x(), -frd.z(), error_mps};
}

}  // namespace drydock::emulate
