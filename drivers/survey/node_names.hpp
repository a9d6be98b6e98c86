#pragma once

#include <cstdint>
#include <string>

#include "drivers/wire/j1939/j1939.hpp"

namespace drydock::survey {

/// Of the 11-bit code in a NAME, for the makers one meets on boats; empty: not in our list, which
/// is a part of canboat's.
std::string_view manufacturer(std::uint16_t code);

/// NMEA 2000's device classes; empty: none has that number.
std::string_view device_class(std::uint8_t number);

/// "Airmar, Instrumentation, function 130, serial 12345".
std::string in_words(const wire::j1939::Name& name);

}  // namespace drydock::survey
