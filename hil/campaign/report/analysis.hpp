#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hil/campaign/report/results.hpp"
#include "hil/campaign/statistics/quantile.hpp"
#include "hil/campaign/statistics/sensitivity.hpp"

namespace drydock::campaign {

/// What a parameter does to a figure. A list of texts has no correlation, a random draw no levels.
struct Influence {
  std::string parameter;
  std::optional<RankCorrelation> correlation{};
  std::optional<LevelEffect> effect{};
};

struct WorstRun {
  std::size_t index = 0;
  double value = 0;
};

/// One figure over all runs that have it.
struct FigureAnalysis {
  const FigureConfig* figure = nullptr;  // lives in the results
  std::size_t count = 0;
  double mean = 0, deviation = 0, lowest = 0, highest = 0;
  std::vector<Quantile> quantiles{};
  std::vector<WorstRun> worst{};  ///< the worst first
  std::vector<Influence> influences{};
};

/// Figures that at least one run has, in the order of the file.
std::vector<FigureAnalysis> analysis_of(const Results& results);

/// How bad a value is: the larger, the worse.
double badness(Better better, double value);

}  // namespace drydock::campaign
