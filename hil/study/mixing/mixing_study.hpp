#pragma once

#include "hil/study/mixing/mixing_statistics.hpp"
#include "hil/study/study.hpp"

namespace drydock::study {

/// Kim, Lee, Han, "Mixing Algorithm for Attitude Computation of Underwater Vehicle Using Fuzzy
/// Theory" (1996), chapter 4, with a fourth type beside the paper's three.
Result mixing_study(const Options& options, Progress& progress);

/// Table 6: a step of each type on readings of the experiment's first run.
std::vector<Workload> mixing_workloads();

/// Cells of the paper's Table 3 that the inference gives, of 36.
int mixing_table3_cells();

std::vector<Figure> mixing_figures(const MixingExperiment& experiment,
                                   const MixingResults& results);

}  // namespace drydock::study
