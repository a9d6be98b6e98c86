#pragma once

#include <span>
#include <string>
#include <vector>

#include "rig_config/load.hpp"
#include "rig_config/rules/rules.hpp"

namespace drydock::rig_config {

/// Which of the rules the value at `path` breaks, in words. What its members break is not told.
Problems explain(const Ruled& ruled, const std::string& file, const std::string& path);

/// " (did you mean 'x'?)" for a likely slip of the pen, else nothing.
std::string did_you_mean(const std::string& word, std::span<const std::string> known);

/// "a, b, c"
std::string listed(std::span<const std::string> words);

}  // namespace drydock::rig_config
