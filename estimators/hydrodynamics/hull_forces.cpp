#include "estimators/hydrodynamics/hull_forces_body.hpp"

namespace drydock::hydrodynamics {

template Wrench hull_forces(const Coefficients&, const Velocity&, const Control&);

}  // namespace drydock::hydrodynamics
