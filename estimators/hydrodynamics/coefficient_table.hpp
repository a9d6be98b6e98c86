#pragma once

#include <span>
#include <string_view>

#include "estimators/hydrodynamics/coefficients.hpp"

namespace drydock::hydrodynamics {

/// One coefficient with the names of vehicle files and papers: axis "Y", name "v|r|".
struct NamedCoefficient {
  std::string_view axis, name;
  int length_power;  ///< n of the prime system: Y_{v|r|} = Y'_{v|r|} rho/2 L^n
  double Coefficients::*member;
};

/// All coefficients, axis by axis.
std::span<const NamedCoefficient> coefficient_table();

/// The entry, or nullptr if there is no such coefficient.
const NamedCoefficient* find_coefficient(std::string_view axis, std::string_view name);

/// rho/2 L^n, the factor from a prime value to SI; `density` in kg/m^3, `length` in m.
double prime_unit(int length_power, double density, double length);

}  // namespace drydock::hydrodynamics
