#include "hil/motion/vehicle/vehicle_motion.hpp"

#include <cmath>

#include "estimators/frame/earth.hpp"
#include "estimators/vehicle/vehicle.hpp"
#include "hil/motion/vehicle/contact.hpp"
#include "hil/motion/vehicle/kinematic_hull.hpp"
#include "rig_config/kinematic_vehicle.hpp"

namespace drydock::motion {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Values of the Earth that hardly change within a step: 5e-9 relative per step at 3 m/s.
struct VehicleMotion::Earth {
  double sin_latitude, cos_latitude, north_radius_m, east_radius_m, height_m;
  Vector3d rate_ned;

  explicit Earth(const VehicleState& s)
      : sin_latitude(std::sin(s.latitude_rad)),
        cos_latitude(std::cos(s.latitude_rad)),
        north_radius_m(frame::meridian_radius(s.latitude_rad) + s.height_m),
        east_radius_m(frame::transverse_radius(s.latitude_rad) + s.height_m),
        height_m(s.height_m),
        rate_ned(frame::wgs84::earth_rate_radps * Vector3d{cos_latitude, 0, -sin_latitude}) {}

  /// The rotation of NED relative to the Earth, eq. (2).
  Vector3d transport_rate(const Vector3d& velocity_ned) const {
    const double east = velocity_ned.y() / east_radius_m;
    return {east, -velocity_ned.x() / north_radius_m, -east * sin_latitude / cos_latitude};
  }

  /// Eq. (1) for a displacement. Its middle gives the cosine and the height.
  void move(VehicleState& s, const Vector3d& north_east_down) const {
    const double sinking = north_east_down.z() / 2;
    const double north = north_east_down.x() / (north_radius_m - sinking);
    const double cosine = cos_latitude - sin_latitude * north / 2;
    s.latitude_rad += north;
    s.longitude_rad += north_east_down.y() / ((east_radius_m - sinking) * cosine);
    s.height_m -= north_east_down.z();
  }
};

Vector3d acceleration_ned(const VehicleState& s, const VehicleRate& rate, const ocean::Ocean& ocean,
                          double t_s) {
  const Vector3d through_water = s.velocity.head<3>(), omega = s.velocity.tail<3>();
  return s.body_to_ned * (rate.velocity.head<3>() + omega.cross(through_water)) +
         ocean.current_rate_ned(-s.height_m, rate.velocity_ned.z(), t_s);
}

VehicleMotion::VehicleMotion(const rig_config::MissionConfig& mission, Edges edges)
    : ocean_(mission.ocean, {mission.latitude_rad, mission.longitude_rad, 0}), edges_(edges) {
  if (!rig_config::is_kinematic(mission.vehicle.value()))
    model_.emplace(vehicle::dimensional(*mission.vehicle));
}

VehicleRate VehicleMotion::rate(const VehicleState& s, const hydrodynamics::Control& control,
                                double t) const {
  return rate(s, control, t, Earth(s));
}

VehicleRate VehicleMotion::rate(const VehicleState& s, const hydrodynamics::Control& control,
                                double t, const Earth& earth) const {
  const Matrix3d body_to_ned = s.body_to_ned.toRotationMatrix();
  const auto omega = s.velocity.tail<3>();
  VehicleRate rate;
  const Vector3d through_water = s.velocity.head<3>();
  rate.velocity_ned = ocean_.current_ned(-s.height_m, t);
  rate.velocity_ned.noalias() += body_to_ned * through_water;
  rate.attitude = (s.body_to_ned * Quaterniond{0, omega.x(), omega.y(), omega.z()}).coeffs() / 2;
  if (!model_) {
    rate.velocity = kinematic_acceleration(s.velocity, body_to_ned.transpose(), control);
  } else {
    // Eq. (4) of the vehicle has 2 w_IE x V; here it must be (2 w_IE + w_EN) x V.
    const Vector3d turning = earth.rate_ned + earth.transport_rate(rate.velocity_ned) / 2;
    rate.velocity = model_->acceleration(s.velocity, body_to_ned.transpose(), control, turning);
  }
  if (edges_ == Edges::closed) add_contact(s, ocean_, t, rate);
  return rate;
}

VehicleState VehicleMotion::step(const VehicleState& s, const VehicleRate& k1, Actuators& actuators,
                                 const Command& command, double t, double h) const {
  const Earth earth(s);
  const auto moved = [&](const VehicleRate& rate, double by) {
    VehicleState to = s;
    to.height_m -= by * rate.velocity_ned.z();
    to.body_to_ned.coeffs() += by * rate.attitude;
    to.velocity += by * rate.velocity;
    return to;
  };
  actuators.step(command, h / 2);
  const auto middle = actuators.control();
  const VehicleRate k2 = rate(moved(k1, h / 2), middle, t + h / 2, earth);
  const VehicleRate k3 = rate(moved(k2, h / 2), middle, t + h / 2, earth);
  actuators.step(command, h / 2);
  const VehicleRate k4 = rate(moved(k3, h), actuators.control(), t + h, earth);

  VehicleState to = s;
  to.velocity += h / 6 * (k1.velocity + 2 * (k2.velocity + k3.velocity) + k4.velocity);
  to.body_to_ned.coeffs() += h / 6 * (k1.attitude + 2 * (k2.attitude + k3.attitude) + k4.attitude);
  to.body_to_ned.normalize();
  earth.move(to,
             h / 6 * (k1.velocity_ned + 2 * (k2.velocity_ned + k3.velocity_ned) + k4.velocity_ned));
  return to;
}

}  // namespace drydock::motion
