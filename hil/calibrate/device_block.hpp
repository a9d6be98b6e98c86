#pragma once

#include <string>

namespace drydock::calibrate {

/// The text of a rig file in which the block [[device]] of this name has `key = value`, in the
/// place of what it had or behind its name. Every other byte stays. Throws std::runtime_error with
/// one line if there is no such block, or if the key is a table or spans several lines.
std::string with_key(const std::string& rig, const std::string& device, const std::string& key,
                     const std::string& value);

}  // namespace drydock::calibrate
