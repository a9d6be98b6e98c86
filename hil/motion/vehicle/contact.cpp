#include "hil/motion/vehicle/contact.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/frame/earth.hpp"

namespace drydock::motion {
namespace {

constexpr double near_m = 5;  // farther away nothing that the equations allow is held
constexpr double stiffness_radps = 20;

/// How near a vehicle is to what holds it, and how that changes.
struct Approach {
  double gap_m, closing_mps, closing_mps2;
};

/// The push that is needed so that the gap goes to zero as the critically damped
///   gap'' + 2 w gap' + w^2 gap = 0,
/// which does not pass zero; none where the vehicle is slower than that by itself.
double push_mps2(const Approach& a) {
  constexpr double w = stiffness_radps;
  return std::max(0.0, a.closing_mps2 + 2 * w * a.closing_mps - w * w * a.gap_m);
}

/// How fast the bed under a moving vehicle sinks, m/s.
double bed_sinks_mps(const VehicleState& s, const Eigen::Vector3d& velocity_ned, double bed_m,
                     const ocean::Ocean& ocean) {
  constexpr double ahead_s = 0.01;
  const double north = ahead_s * velocity_ned.x(), east = ahead_s * velocity_ned.y();
  const double there_m = ocean.bed_depth_m(
      s.latitude_rad + north / frame::meridian_radius(s.latitude_rad),
      s.longitude_rad +
          east / (frame::transverse_radius(s.latitude_rad) * std::cos(s.latitude_rad)));
  return (there_m - bed_m) / ahead_s;
}

}  // namespace

void add_contact(const VehicleState& s, const ocean::Ocean& ocean, double t_s, VehicleRate& rate) {
  const double bed_m = ocean.bed_depth_m(s.latitude_rad, s.longitude_rad);
  const double above_bed_m = bed_m + s.height_m, below_top_m = highest_m - s.height_m;
  if (above_bed_m > near_m && below_top_m > near_m) return;
  const double sinks_mps = rate.velocity_ned.z();
  const double sinks_mps2 = acceleration_ned(s, rate, ocean, t_s).z();
  double push_down = 0;
  if (below_top_m <= near_m) push_down = push_mps2({below_top_m, -sinks_mps, -sinks_mps2});
  if (above_bed_m <= near_m)
    push_down -= push_mps2(
        {above_bed_m, sinks_mps - bed_sinks_mps(s, rate.velocity_ned, bed_m, ocean), sinks_mps2});
  if (push_down == 0) return;
  const Eigen::Vector3d push_ned{0, 0, push_down};
  rate.velocity.head<3>() += s.body_to_ned.conjugate() * push_ned;
}

}  // namespace drydock::motion
