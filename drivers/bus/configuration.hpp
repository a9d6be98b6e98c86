#pragma once

#include <string>

namespace drydock::bus {

/// The configuration of Cyclone DDS (CYCLONEDDS_URI) for the bus on a network interface. Drydock's
/// own participants have it, and so must every other Cyclone program that is to be heard.
std::string cyclone_configuration(const std::string& interface);

}  // namespace drydock::bus
