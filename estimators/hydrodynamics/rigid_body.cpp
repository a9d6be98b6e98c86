#include "estimators/hydrodynamics/rigid_body_body.hpp"

namespace drydock::hydrodynamics {

using Eigen::Vector3d;

template Wrench rigid_body_forces(const RigidBody&, const Velocity&, const Vector3d&);
template Matrix6 rigid_body_partials(const RigidBody&, const Velocity&, const Vector3d&);
template Eigen::Matrix<double, 6, 3> rigid_body_attitude_partials(const RigidBody&, const Velocity&,
                                                                  const Vector3d&);
template Wrench hydrostatic_forces(const RigidBody&, const Vector3d&);
template Eigen::Matrix<double, 6, 3> hydrostatic_attitude_partials(const RigidBody&,
                                                                   const Vector3d&);

}  // namespace drydock::hydrodynamics
