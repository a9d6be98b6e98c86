#include "hil/motion/steered/thruster_hull.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace drydock::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using hydrodynamics::Matrix6;
using hydrodynamics::Velocity;
using hydrodynamics::Wrench;

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

Matrix6 rigid_mass(const rig_config::ThrusterVehicleConfig& config) {
  const Matrix3d to_gravity = config.mass_kg * cross_matrix({0, 0, config.z_G_m});
  Matrix6 mass = Matrix6::Zero();
  mass.topLeftCorner<3, 3>() = config.mass_kg * Matrix3d::Identity();
  mass.topRightCorner<3, 3>() = -to_gravity;
  mass.bottomLeftCorner<3, 3>() = to_gravity;
  mass.bottomRightCorner<3, 3>() = Vector3d(config.moments_of_inertia_kgm2.data()).asDiagonal();
  return mass;
}

Matrix6 added_mass(const rig_config::ThrusterVehicleConfig& config) {
  return Velocity(config.added_mass.data()).asDiagonal();
}

/// Force and moment of C(v) v, of the momenta in the turning body.
Wrench turning_momenta(const Matrix6& mass, const Velocity& velocity) {
  const Wrench momenta = mass * velocity;
  const Vector3d linear = momenta.head<3>(), angular = momenta.tail<3>();
  const Vector3d v = velocity.head<3>(), omega = velocity.tail<3>();
  Wrench result;
  result << omega.cross(linear), v.cross(linear) + omega.cross(angular);
  return result;
}

}  // namespace

ThrusterHull::ThrusterHull(const rig_config::ThrusterVehicleConfig& config)
    : config_(config),
      mass_(rigid_mass(config)),
      inverse_mass_((mass_ + added_mass(config)).inverse()),
      linear_(config.linear_damping.data()),
      quadratic_(config.quadratic_damping.data()) {}

Wrench ThrusterHull::hydrostatics(const Vector3d& down, double height_m) const {
  const double under_water = std::clamp(1 - height_m / hull_height_m, 0.0, 1.0);
  const Vector3d weight = config_.weight_n * down;
  const Vector3d buoyancy = -config_.buoyancy_n * under_water * down;
  Wrench result;
  result << weight + buoyancy,
      Vector3d(0, 0, config_.z_G_m).cross(weight) + Vector3d(0, 0, config_.z_B_m).cross(buoyancy);
  return result;
}

Velocity ThrusterHull::acceleration(const Velocity& velocity, const Matrix3d& body_to_ned,
                                    double height_m, const Wrench& wrench) const {
  const Vector3d down = body_to_ned.row(2).transpose();
  const Velocity damping =
      (linear_.array() + quadratic_.array() * velocity.array().abs()) * velocity.array();
  return inverse_mass_ *
         (wrench + hydrostatics(down, height_m) - damping - turning_momenta(mass_, velocity));
}

}  // namespace drydock::motion
