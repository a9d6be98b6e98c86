#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace drydock::terminal {

/// Seconds of `90`, `60s`, `10min` or `5.5h`. Empty for any other text, for negative times and for
/// times longer than a century.
std::optional<double> parse_duration(std::string_view text);
std::string no_duration(std::string_view text);  ///< the error line for a text that is no duration

}  // namespace drydock::terminal
