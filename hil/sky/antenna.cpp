#include "hil/sky/antenna.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drivers/measurement/units.hpp"

namespace drydock::sky {

double antenna_elevation(const Eigen::Vector3d& toward_body,
                         const Eigen::Vector3d& boresight_body) {
  return std::asin(std::clamp(toward_body.dot(boresight_body), -1.0, 1.0));
}

double antenna_power(double elevation_rad) {
  constexpr double width_rad = 64.58 * units::degree;
  const double off_boresight = (std::numbers::pi / 2 - elevation_rad) / width_rad;
  return std::exp(-off_boresight * off_boresight);
}

}  // namespace drydock::sky
