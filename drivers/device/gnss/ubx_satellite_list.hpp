#pragma once

#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/ubx/ubx_satellites.hpp"

namespace drydock::device {

using SatelliteList = decltype(measurement::GnssSatellites::satellites);

/// From NAV-SAT or NAV-SVINFO. It omits satellites that the receiver cannot identify yet.
SatelliteList satellite_list(std::span<const wire::UbxSatellite> satellites);

/// From NAV-SIG. A satellite has the C/N0 of its strongest signal, and it is used if any of its
/// signals is used. Signals have no direction.
SatelliteList satellite_list(std::span<const wire::UbxSignal> signals);

}  // namespace drydock::device
