#include "hil/twin/mission_text.hpp"

#include <fmt/format.h>

#include "drivers/measurement/units.hpp"

namespace drydock::twin {
namespace {

double degrees(double radians) { return radians * units::degrees_per_radian; }

}  // namespace

std::string poses_text(const motion::Poses& poses) {
  // A micrometre: rounding at steps of 0.1 s then adds 1e-4 m/s2 at most.
  std::string text = "time_s,latitude_deg,longitude_deg,height_m,qw,qx,qy,qz\n";
  for (const auto& pose : poses) {
    const auto& p = pose.position;
    const auto& q = pose.body_to_ned;
    text += fmt::format("{:.9f},{:.11f},{:.11f},{:.6f},{:.10f},{:.10f},{:.10f},{:.10f}\n", pose.t_s,
                        degrees(p.latitude_rad), degrees(p.longitude_rad), p.height_m, q.w(), q.x(),
                        q.y(), q.z());
  }
  return text;
}

std::string mission_text(const motion::Poses& poses, const rig_config::OceanConfig& ocean,
                         const std::string& source) {
  const auto& origin = poses.front().position;
  std::string text = fmt::format(
      "# The way of {}, smoothed.\n\n[mission]\nlatitude_deg = {:.9f}\nlongitude_deg = {:.9f}\n\n"
      "[track]\nfile = \"track.csv\"\n\n[ocean]\nbed = {{ kind = \"plane\", depth_m = {:.2f} }}\n",
      source, degrees(origin.latitude_rad), degrees(origin.longitude_rad), ocean.bed.depth_m);
  for (const auto& current : ocean.current)
    text +=
        fmt::format("current = [{{ depth_m = 0.0, velocity_ned_mps = [{:.4f}, {:.4f}, 0.0] }}]\n",
                    current.velocity_ned_mps[0], current.velocity_ned_mps[1]);
  return text;
}

}  // namespace drydock::twin
