#include "estimators/navigation/error_model_body.hpp"

namespace drydock::navigation {

template ErrorDynamics error_dynamics(const NavigationState& state,
                                      const Eigen::Vector3d& force_ned, const HeightLoop& loop);

template ErrorDynamics error_dynamics(const NavigationState& state, const frame::LocalEarth& earth,
                                      const Eigen::Vector3d& force_ned, const HeightLoop& loop);

}  // namespace drydock::navigation
