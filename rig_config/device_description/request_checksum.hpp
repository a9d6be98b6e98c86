#pragma once

#include <string>
#include <string_view>

#include "drivers/wire/described/plan.hpp"

namespace drydock::rig_config {

/// Puts the protocol's checksum behind a request, as behind its messages: `*hh` and the line end
/// of a sentence, bytes of a binary frame. Returns why it cannot; empty: it has.
std::string_view add_checksum(const wire::described::Plan& plan, std::string& request);

}  // namespace drydock::rig_config
