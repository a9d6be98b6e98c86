#include "hil/study/perturbation.hpp"

#include <stdexcept>

#include "estimators/hydrodynamics/coefficient_table.hpp"
#include "estimators/hydrodynamics/model.hpp"
#include "hil/sensor/random.hpp"

namespace drydock::study {

hydrodynamics::Vehicle perturbed(const hydrodynamics::Vehicle& vehicle, std::uint64_t seed,
                                 double sigma) {
  if (!(sigma >= 0)) throw std::invalid_argument("a perturbation needs a sigma of 0 or more");
  if (!hydrodynamics::is_mass(hydrodynamics::mass_matrix(vehicle)))
    throw std::invalid_argument("the vehicle to be perturbed has no positive mass");
  sensor::RandomStream random(seed, "vehicle", "coefficients");
  hydrodynamics::Vehicle drawn;
  do {
    drawn = vehicle;
    for (const auto& entry : hydrodynamics::coefficient_table())
      drawn.coefficients.*entry.member *= 1 + sigma * random.normal();
  } while (!hydrodynamics::is_mass(hydrodynamics::mass_matrix(drawn)));
  return drawn;
}

}  // namespace drydock::study
