#pragma once

#include <optional>
#include <string_view>

#include "rig_config/load.hpp"

namespace drydock::rig_config {

inline constexpr std::size_t largest_file = 1u << 20;  ///< bytes of a configuration file

/// The first place where a text goes beyond what a configuration file is read with: its size,
/// brackets in brackets, parts of a dotted key. The parser and all who walk its tables call
/// themselves once a level, so that depth is stack; the parser itself bounds only brackets.
std::optional<Problem> beyond_limits(std::string_view text, const std::string& path);

}  // namespace drydock::rig_config
