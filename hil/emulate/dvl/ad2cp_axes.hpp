#pragma once

#include <array>

#include "drivers/wire/dvl/ad2cp_messages.hpp"
#include "hil/sensor/dvl.hpp"

/// How a Nortek DVL makes X, Y, Z1 and Z2 of its beams. Source: 3014 records of a DVL333, whose
/// axes follow from their beams within 1e-5 m/s.
namespace drydock::emulate {

/// Beams 1 to 4 look to +X+Y, +X-Y, -X-Y and -X+Y. The angle is that of the records; the maker's is
/// 25 degrees.
inline constexpr double ad2cp_beam_angle_rad = 0.434564;

/// The order of JanusHead's beams, turned by 45 degrees, in the DVL's numbers.
inline constexpr std::array<std::size_t, 4> janus_beam_of_ad2cp{2, 0, 3, 1};

/// Velocities and merits of the axes from those of the beams. If one beam is lost, the other three
/// give X, Y and, as Z1, the Z of the whole pair; Z2 is empty. With fewer beams nothing is known.
void set_axes(const wire::ad2cp::Estimates& beams, double beam_angle_rad,
              wire::ad2cp::Estimates& axes);

}  // namespace drydock::emulate
