#pragma once

#include <filesystem>

#include "hil/campaign/report/results.hpp"

namespace drydock::campaign {

/// Writes the results as an SQLite file: table `runs` with a row for each run and a column for each
/// parameter and figure, table `campaign` with the campaign's file. Equal results give equal bytes:
/// it has no times. The file is there as a whole or not at all. Throws std::runtime_error.
void write_store(const std::filesystem::path& path, const Results& results);

}  // namespace drydock::campaign
