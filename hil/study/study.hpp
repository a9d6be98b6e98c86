#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hil/report/figure.hpp"
#include "hil/report/table.hpp"
#include "hil/study/campaign.hpp"

/// The papers' experiments. Each is a function from options to tables, figures and numbers.
namespace drydock::study {

/// Depends only on the seed and the number of runs, not on times, host or number of threads.
struct Result {
  std::size_t runs = 0;  ///< finished runs; fewer than requested after a stop
  std::vector<report::Table> tables;
  std::vector<report::Figure> figures;
  nlohmann::ordered_json json;  ///< an object; docs/estimators/study.md describes its keys
};

/// A computation that takes time on board. A Result contains no times, so the caller measures it.
struct Workload {
  std::string key;   ///< key in the result's JSON for its `ns_per_step`
  std::string name;  ///< in the table
  std::function<void(std::size_t steps)> run;
};

struct Study {
  std::string_view name;   ///< on the command line
  std::string_view title;  ///< the repeated experiment and its authors
  /// If it is stopped before the first run is finished, the result has no runs and nothing is
  /// shown. Throws std::runtime_error with one line if a required file is missing.
  Result (*run)(const Options& options, Progress& progress);
  std::vector<Workload> (*workloads)() = nullptr;  ///< the others are compared with the first
  /// The allowed names of Options::cases; null: the study has no separate cases.
  std::vector<std::string_view> (*cases)() = nullptr;
};

/// All studies in the order of the papers.
std::span<const Study> studies();

}  // namespace drydock::study
