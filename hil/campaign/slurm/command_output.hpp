#pragma once

#include <string>
#include <vector>

namespace drydock::campaign {

struct CommandOutput {
  int code = 0;  ///< exit code; 127: it could not be started
  std::string output, errors;
};

/// Runs a program that ends soon, such as squeue, and keeps what it says.
CommandOutput output_of(const std::vector<std::string>& words);

}  // namespace drydock::campaign
