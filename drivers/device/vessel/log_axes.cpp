#include "drivers/device/vessel/log_axes.hpp"

#include <cmath>
#include <utility>

#include "drivers/device/vehicle_limits.hpp"

namespace drydock::device {

namespace {

/// A component along one body axis, of the sensor's speeds that it depends on. Empty if one of them
/// is missing.
std::optional<double> along(double of_longitudinal, double of_transverse,
                            const std::optional<double>& longitudinal_mps,
                            const std::optional<double>& transverse_mps) {
  constexpr double none = 1e-9;  // what a half turn leaves of sin(180 degrees)
  double sum = 0;
  for (const auto& [part, speed] :
       {std::pair(of_longitudinal, &longitudinal_mps), std::pair(of_transverse, &transverse_mps)}) {
    if (std::abs(part) < none) continue;
    if (!*speed) return {};
    sum += part * **speed;
  }
  return sum;
}

}  // namespace

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
  } else {
    const Eigen::Vector3d x = mounting_.to_body(Eigen::Vector3d::UnitX());
    const Eigen::Vector3d y = mounting_.to_body(Eigen::Vector3d::UnitY());
    into.longitudinal_mps = along(x.x(), y.x(), longitudinal_mps, transverse_mps);
    into.transverse_mps = along(x.y(), y.y(), longitudinal_mps, transverse_mps);
    if (longitudinal_mps && !into.longitudinal_mps)
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
