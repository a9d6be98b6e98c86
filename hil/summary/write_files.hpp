#pragma once

#include <string>

#include "hil/summary/summary.hpp"

namespace drydock::summary {

/// Where a summary goes; an empty name: nowhere.
struct SummaryFiles {
  std::string json, report, junit;  ///< file, folder, file
};

/// A file that cannot be written does not keep the others from being written. Throws at the end;
/// what() has a line for each of them. Prints where the report is.
void write_files(const Summary& summary, const SummaryFiles& files, const std::string& rig_file);

}  // namespace drydock::summary
