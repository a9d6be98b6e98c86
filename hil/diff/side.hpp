#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "hil/summary/summary.hpp"

namespace drydock::diff {

/// One of two runs.
struct Side {
  std::string file;
  nlohmann::ordered_json summary;
  std::optional<summary::Summary> curves;  ///< only of a recording
};

/// Reads a summary (`drydock run --json`), or plays a recording. Throws std::runtime_error with one
/// line if the file is neither.
Side read_side(const std::string& file);

}  // namespace drydock::diff
