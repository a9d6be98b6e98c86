#include "drivers/device/vessel/log_axes.hpp"

namespace drydock::device {

void LogAxes::publish(const std::optional<double>& longitudinal_mps,
                      const std::optional<double>& transverse_mps,
                      const measurement::Origin& origin, Output& out) const {
  measurement::WaterSpeed result;
  result.origin = origin;
  if (mounting_.is_identity()) {
    result.longitudinal_mps = longitudinal_mps;
    result.transverse_mps = transverse_mps;
  } else if (longitudinal_mps && transverse_mps) {
    const Eigen::Vector3d body = mounting_.to_body({*longitudinal_mps, *transverse_mps, 0});
    result.longitudinal_mps = body.x();
    result.transverse_mps = body.y();
  } else if (longitudinal_mps) {
    out.report("the log is mounted turned and gives no transverse speed: no speed along body x");
  }
  if (result.longitudinal_mps || result.transverse_mps) result.sigma_mps = sigma_mps_;
  out.publish(result);
}

}  // namespace drydock::device
