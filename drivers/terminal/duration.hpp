#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace drydock::terminal {

/// Seconds of `90`, `60s`, `10min` or `5.5h`; empty for anything else, for negative times and for
/// more than a century.
std::optional<double> parse_duration(std::string_view text);
std::string no_duration(std::string_view text);  ///< the line for whoever typed that

}  // namespace drydock::terminal
