#include "estimators/navigation/sdins_body.hpp"

namespace drydock::navigation {

template class BasicSdins<double>;

Eigen::Quaterniond far_turn(const Eigen::Vector3d& rotation) {
  return Eigen::Quaterniond{
      Eigen::AngleAxisd{2 * std::sqrt(rotation.squaredNorm() / 4), rotation.normalized()}};
}

Eigen::Quaterniond quaternion_of(const Eigen::Vector3d& rotation) {
  return quaternion_of<double>(rotation);
}

}  // namespace drydock::navigation
