#pragma once

#include "drivers/wire/described/description.hpp"
#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// "FA 49 01" -> three bytes. Empty: not pairs of hexadecimal digits.
std::optional<std::string> hex_bytes(std::string text);

/// The tables `[[start]]` or `[[poll]]`: what the driver sends, and the message that answers it.
/// `description` has its messages already. Problems are appended.
std::vector<wire::described::Request> read_requests(const Node& root, const char* group,
                                                    const wire::described::Description& description,
                                                    const std::string& file, Problems& problems);

/// An emulated device says what a request wants to hear, where no 'emulate' says another number.
void answer_as_wanted(wire::described::Plan& plan,
                      const std::vector<wire::described::Request>& requests);

}  // namespace drydock::rig_config
