#pragma once

#include <optional>
#include <string>
#include <vector>

namespace drydock::monitor {

/// The last known value of one field for a person: "velocity", "1.200 0.100 0.000", "m/s".
struct ShownValue {
  std::string name, text, unit;
  std::vector<double> numbers{};  ///< in `unit`, NaN where there is none; empty: a word
  double older_s = 0;             ///< than the device's newest measurement

  /// The text with its unit, and with its age if a newer measurement came without it.
  std::string full() const;
};

}  // namespace drydock::monitor
