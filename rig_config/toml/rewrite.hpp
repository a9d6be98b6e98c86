#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace drydock::rig_config {

/// Changes of the values of a document before it is given away.
struct Rewriting {
  /// The new value of a number, by its key. Numbers in arrays do not change.
  std::function<double(std::string_view key, double value)> number;
  bool without_dates = false;  ///< keys with a date are left out
};

/// The TOML document with changed values and without comments. Empty: the text is not TOML.
std::optional<std::string> rewrite(std::string_view document, const Rewriting& rewriting);

}  // namespace drydock::rig_config
