#include "estimators/velocity/sway_model_body.hpp"

namespace drydock::velocity {

template class BasicSwayModel<double>;

}  // namespace drydock::velocity
