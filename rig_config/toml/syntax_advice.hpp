#pragma once

#include <string>
#include <string_view>

namespace drydock::rig_config {

/// What to do about a mistake in the grammar of TOML: "; a number has a point, not a comma". `what`
/// is the parser's own text, `line` the text of the line where it stopped. Empty: the parser's text
/// tells enough.
std::string syntax_advice(std::string_view what, std::string_view line);

}  // namespace drydock::rig_config
