#pragma once

#include <cstdio>
#include <string>

namespace drydock::diff {

struct DiffOptions {
  std::string a, b;         ///< recordings, or summaries of runs
  double tolerance = 0;     ///< relative
  std::string report = {};  ///< folder; empty: none
  bool json = false;
};

/// `drydock diff`: two runs side by side. Exit code: 0 they could be compared, whatever differs; 1
/// a file cannot be read or written.
int diff(const DiffOptions& options, std::FILE* out, std::FILE* err);

}  // namespace drydock::diff
