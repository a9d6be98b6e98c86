#pragma once

#include <optional>
#include <string_view>

#include "rig_config/load.hpp"

namespace drydock::rig_config {

inline constexpr std::size_t largest_file = 1u << 20;  ///< bytes of a configuration file

/// The first place where a text exceeds the limits of a configuration file: its size, the depth of
/// brackets, the parts of a dotted key. The parser and the code that visits its tables recurse once
/// per level, so a deep file would need much stack. The parser itself limits only brackets.
std::optional<Problem> beyond_limits(std::string_view text, const std::string& path);

}  // namespace drydock::rig_config
