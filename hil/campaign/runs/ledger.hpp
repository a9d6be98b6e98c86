#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "hil/campaign/runs/record.hpp"

namespace drydock::campaign {

/// What all journals of a folder say together, each run once.
struct Ledger {
  std::map<std::size_t, Record> records;  ///< by index
  std::size_t damaged_lines = 0;          ///< torn or changed; their runs are missing and run again
  std::size_t repeated = 0;               ///< runs that were done more than once
  std::vector<std::size_t> differing;     ///< of these, those whose figures were not the same
};

/// Reads the journals. Of several records of a run, one without a failure counts, and of equally
/// good ones the first in the order of their lines; so the order of the files does not matter.
/// Records of runs that the campaign does not have count as damaged. `label`: only of journals
/// whose names begin so.
Ledger read_ledger(const std::filesystem::path& folder, std::size_t runs, std::size_t figures,
                   const std::string& label = {});

/// The runs without a sound record, in order.
std::vector<std::size_t> missing_runs(const Ledger& ledger, std::size_t runs);

}  // namespace drydock::campaign
