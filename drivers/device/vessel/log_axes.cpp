#include "drivers/device/vessel/log_axes.hpp"

#include "drivers/device/vehicle_limits.hpp"

namespace drydock::device {

bool LogAxes::resolve(const std::optional<double>& longitudinal_mps,
                      const std::optional<double>& transverse_mps, measurement::WaterSpeed& into,
                      Output& out) const {
  constexpr double most = fastest_in_water_mps;
  if (!(std::abs(longitudinal_mps.value_or(0)) <= most) ||
      !(std::abs(transverse_mps.value_or(0)) <= most)) {
    out.refuse("a speed through the water over 50 m/s was dropped: damaged on its way");
    return false;
  }
  if (mounting_.is_identity()) {
    into.longitudinal_mps = longitudinal_mps;
    into.transverse_mps = transverse_mps;
  } else if (longitudinal_mps && transverse_mps) {
    const Eigen::Vector3d body = mounting_.to_body({*longitudinal_mps, *transverse_mps, 0});
    into.longitudinal_mps = body.x();
    into.transverse_mps = body.y();
  } else if (longitudinal_mps) {
    out.report("the log is mounted turned and gives no transverse speed: no speed along body x");
  }
  if (into.longitudinal_mps) *into.longitudinal_mps /= scale_;
  if (into.transverse_mps) *into.transverse_mps /= scale_;
  if (into.longitudinal_mps || into.transverse_mps) into.sigma_mps = sigma_mps_;
  return true;
}

void LogAxes::publish(const std::optional<double>& longitudinal_mps,
                      const std::optional<double>& transverse_mps,
                      const measurement::Origin& origin, Output& out) const {
  measurement::WaterSpeed result;
  result.origin = origin;
  if (resolve(longitudinal_mps, transverse_mps, result, out)) out.publish(result);
}

}  // namespace drydock::device
