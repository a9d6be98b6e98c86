#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hil/study/campaign.hpp"
#include "hil/study/figure.hpp"

/// The papers' experiments: each a function from options to tables, figures and numbers.
namespace drydock::study {

/// Text, ready to print: the paper's figures beside ours. Every row has as many cells as columns.
struct Table {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  std::string note;  ///< below the table; may be empty
};

/// Depends on the seed and the number of runs alone: no times, no host, no number of threads.
struct Result {
  std::size_t runs = 0;  ///< done; fewer than asked for where it was stopped
  std::vector<Table> tables;
  std::vector<Figure> figures;
  nlohmann::ordered_json json;  ///< an object; docs/estimators/study.md names its keys
};

/// What takes time on board. A result has no times, so whoever runs the study measures it.
struct Workload {
  std::string key;   ///< of the result's JSON, which gets its `ns_per_step`
  std::string name;  ///< in the table
  std::function<void(std::size_t steps)> run;
};

struct Study {
  std::string_view name;   ///< as the command line has it
  std::string_view title;  ///< what is repeated, and whose
  /// Stopped before the first run is done, it gives a result of no runs, of which nothing is shown.
  /// Throws std::runtime_error, one line, where a file that it needs is not there.
  Result (*run)(const Options& options, Progress& progress);
  std::vector<Workload> (*workloads)() =
      nullptr;  ///< the first is what the others are compared with
  /// What Options::cases may name; none: the study is run whole.
  std::vector<std::string_view> (*cases)() = nullptr;
};

/// All of them, in the order of the papers.
std::span<const Study> studies();

}  // namespace drydock::study
