#pragma once

#include <cstdint>
#include <string>

#include "drivers/wire/j1939/j1939.hpp"

namespace drydock::survey {

/// Name for the 11-bit manufacturer code in a NAME. The list is a part of canboat's, with makers
/// that are common on boats. Empty if the code is not in the list.
std::string_view manufacturer(std::uint16_t code);

/// NMEA 2000's device classes. Empty if no class has this number.
std::string_view device_class(std::uint8_t number);

/// The profile that a CANopen device type (object 1000h) names: "CiA 404, measuring devices". Empty
/// if there is none, or the list does not have it.
std::string canopen_profile(std::uint32_t device_type);

/// "Airmar, Instrumentation, function 130, serial 12345".
std::string in_words(const wire::j1939::Name& name);

}  // namespace drydock::survey
