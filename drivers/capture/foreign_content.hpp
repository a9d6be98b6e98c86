#pragma once

#include <string_view>

#include "drivers/wire/codec.hpp"

namespace drydock::capture {

/// Why a file that begins so is no CAN capture, and what a person should do: it is compressed, text
/// of 16 bits a letter, or packets of another network. Empty for any other file.
std::string_view foreign_content(wire::Bytes head);

/// ASAM's MDF 4 (MF4), whose bytes are those of no line either.
bool is_measurement_data(wire::Bytes head);

}  // namespace drydock::capture
