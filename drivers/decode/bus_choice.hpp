#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "drivers/link/uri.hpp"

namespace drydock::decode {

/// The bus of a CAN capture of several that holds a device: the one of whose frames alone its
/// driver makes measurements, by `count(interface)`. Empty: the link names an interface, or the
/// capture has one alone, or no bus holds the device. Throws std::runtime_error with one line if
/// several do.
std::string bus_of_device(const link::Uri& uri,
                          const std::function<std::uint64_t(const std::string&)>& count);

}  // namespace drydock::decode
