#pragma once

#include <string_view>

namespace drydock::bus {

/// The text of all IDL files of the bus, one after the other.
std::string_view idl_text();

}  // namespace drydock::bus
