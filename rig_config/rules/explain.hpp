#pragma once

#include <span>
#include <string>
#include <vector>

#include "rig_config/load.hpp"
#include "rig_config/rules/rules.hpp"

namespace drydock::rig_config {

/// The rules that the value at `path` breaks, in words. It does not check the members of the value.
Problems explain(const Ruled& ruled, const std::string& file, const std::string& path);

/// " (did you mean 'x'?)" for a likely typing error, else an empty text.
std::string did_you_mean(const std::string& word, std::span<const std::string> known);

/// "a, b, c"
std::string listed(std::span<const std::string> words);

}  // namespace drydock::rig_config
