#include "estimators/pipeline/inertial/aided_inertial.hpp"

#include <cmath>

#include "estimators/frame/local_earth.hpp"
#include "estimators/pipeline/inertial/coupled_inertial.hpp"
#include "estimators/pipeline/inertial/paper_inertial.hpp"
#include "estimators/pipeline/inertial/sensor_inertial.hpp"

namespace drydock::pipeline {

void fill_navigation(const navigation::NavigationState& state,
                     const Eigen::Matrix<double, 9, 9>& errors, NavigationEstimate& estimate) {
  estimate.position = state.position;
  estimate.velocity_ned = state.velocity_ned;
  estimate.body_to_ned = state.body_to_ned;
  const auto earth = frame::local_earth(state.position.latitude_rad, state.position.height_m);
  Eigen::Matrix<double, 9, 1> unit = Eigen::Matrix<double, 9, 1>::Ones();
  unit(0) = earth.meridian_radius_m + state.position.height_m;
  unit(1) = (earth.transverse_radius_m + state.position.height_m) * earth.cos_latitude;
  unit(2) = -1;
  estimate.covariance = unit.asDiagonal() * errors * unit.asDiagonal();
}

std::unique_ptr<AidedInertial> make_aided_inertial(const InertialOptions& options) {
  switch (options.method) {
    case InertialMethod::coupled: return std::make_unique<CoupledInertial>(options);
    case InertialMethod::paper: return std::make_unique<PaperInertial>(options);
    case InertialMethod::sensors: break;
  }
  return std::make_unique<SensorInertial>(options);
}

}  // namespace drydock::pipeline
