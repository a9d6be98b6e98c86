#include "hil/motion/vehicle/actuator_law.hpp"

#include <algorithm>

#include "drivers/measurement/units.hpp"

namespace drydock::motion {
namespace {

constexpr double advance_per_radian_m = 0.012;
constexpr double stop_rad = 20 * units::degree;
constexpr double slowest_mps = 0.5;  // below this speed the surfaces have no effect

double within_stops(double angle) { return std::clamp(angle, -stop_rad, stop_rad); }

}  // namespace

void set_actuators(Truth& truth) {
  const double u = truth.velocity_body.x();
  const double flow = std::max(u, slowest_mps);
  const double pitch_curvature = truth.rate_body.y() / flow;
  const double yaw_curvature = truth.rate_body.z() / flow;
  truth.rudder_rad = within_stops(-rudder_per_curvature_m * yaw_curvature);
  truth.stern_plane_rad = within_stops(-rudder_per_curvature_m * pitch_curvature);
  truth.bow_plane_rad = -truth.stern_plane_rad;
  truth.propeller_radps = u / advance_per_radian_m;
}

}  // namespace drydock::motion
