#pragma once

#include "hil/study/study.hpp"
#include "hil/study/velocity/velocity_statistics.hpp"

namespace drydock::study {

/// Lee, Ra, Kim, Ahn, Lee, "Gertler-Hagen Hydrodynamic Model Based Velocity Estimation Filter for
/// Long-term Underwater Navigation Without External Position Fix" (2016), chapter 4, and stress
/// cases that the paper does not have, with four methods.
Result velocity_study(const Options& options, Progress& progress);

/// The names of the cases, and `error_budget`.
std::vector<std::string_view> velocity_case_names();

std::vector<report::Table> velocity_tables(const VelocityResults& results);
std::vector<report::Figure> velocity_figures(const VelocityResults& results);
nlohmann::ordered_json velocity_json(const VelocityResults& results);

}  // namespace drydock::study
