#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace drydock::rig_config {

/// What becomes of a document's values when it is to be given away.
struct Rewriting {
  /// The new value of a number, by its key; arrays' numbers are left as they are.
  std::function<double(std::string_view key, double value)> number;
  bool without_dates = false;  ///< keys with a date are left out
};

/// The TOML document again with other values, and without its comments. Empty: it is no TOML.
std::optional<std::string> rewrite(std::string_view document, const Rewriting& rewriting);

}  // namespace drydock::rig_config
