#include "estimators/hydrodynamics/hull_force_partials_body.hpp"

namespace drydock::hydrodynamics {

template Matrix6 hull_force_partials(const Coefficients&, const Velocity&, const Control&);

}  // namespace drydock::hydrodynamics
