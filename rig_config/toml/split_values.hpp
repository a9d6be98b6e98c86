#pragma once

#include <string_view>
#include <vector>

namespace drydock::rig_config {

/// The parts of a text between separators. One inside brackets, braces or quotes does not count.
std::vector<std::string_view> split_values(std::string_view text, char separator);

}  // namespace drydock::rig_config
