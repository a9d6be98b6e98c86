#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace drydock::diff {

using Json = nlohmann::ordered_json;

/// One value that two summaries do not share.
struct Difference {
  std::string what;              ///< "device dvl: bad_checksums"
  std::optional<Json> a, b;      ///< empty: this summary does not have it
  std::optional<double> change;  ///< B - A of two numbers
};

struct Comparison {
  std::size_t compared = 0;  ///< values that both have
  std::vector<Difference> differences;
};

/// Compares the summaries of two runs (docs/use/run.md): first what both have, in the order of A,
/// then what only one has. Devices and estimators are the same if their names are; one that only
/// one run has is one difference, "present". The time that the computer took, and its memory, are
/// left out. `tolerance`: numbers are the same if they differ by at most this part of the larger
/// one.
Comparison compare(const Json& a, const Json& b, double tolerance = 0);

}  // namespace drydock::diff
