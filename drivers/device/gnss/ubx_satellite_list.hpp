#pragma once

#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/ubx/ubx_satellites.hpp"

namespace drydock::device {

using SatelliteList = decltype(measurement::GnssSatellites::satellites);

/// Of NAV-SAT or NAV-SVINFO. Satellites that the receiver cannot name yet are left out.
SatelliteList satellite_list(std::span<const wire::UbxSatellite> satellites);

/// Of NAV-SIG: a satellite's C/N0 is that of its strongest signal, and it is used when any of its
/// signals is. Signals have no direction.
SatelliteList satellite_list(std::span<const wire::UbxSignal> signals);

}  // namespace drydock::device
