#include "hil/steer/physics_line.hpp"

#include <fmt/format.h>

namespace drydock::steer {

std::string_view write_physics(const motion::Truth& truth, double timestamp_s,
                               const frame::Position& origin, std::span<char> out) {
  const Eigen::Vector3d& w = truth.rate_body;
  const Eigen::Vector3d& f = truth.specific_force;
  const Eigen::Vector3d& v = truth.velocity_ned;
  const Eigen::Quaterniond& q = truth.body_to_ned;
  const Eigen::Vector3d p =
      frame::ned_offset(origin, {truth.latitude_rad, truth.longitude_rad, truth.height_m});
  const auto written = fmt::format_to_n(
      out.data(), out.size(),
      "\n{{\"timestamp\":{:.9f},\"imu\":{{\"gyro\":[{:.9f},{:.9f},{:.9f}],"
      "\"accel_body\":[{:.7f},{:.7f},{:.7f}]}},\"position\":[{:.6f},{:.6f},{:.6f}],"
      "\"velocity\":[{:.7f},{:.7f},{:.7f}],\"quaternion\":[{:.10f},{:.10f},{:.10f},{:.10f}],"
      "\"rng_1\":{:.4f}}}\n",
      timestamp_s, w.x(), w.y(), w.z(), f.x(), f.y(), f.z(), p.x(), p.y(), p.z(), v.x(), v.y(),
      v.z(), q.w(), q.x(), q.y(), q.z(), truth.bed_depth_m + truth.height_m);
  return written.size <= out.size() ? std::string_view(out.data(), written.size)
                                    : std::string_view();
}

}  // namespace drydock::steer
