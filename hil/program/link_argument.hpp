#pragma once

#include <string>

namespace drydock::program {

/// Throws BadRig for a word that names no link, file, port or CAN interface, after a line on
/// standard error: what is wrong with it, and the shipped rig or file beside it that was likely
/// meant.
void must_name_link(const std::string& command, const std::string& word);

}  // namespace drydock::program
