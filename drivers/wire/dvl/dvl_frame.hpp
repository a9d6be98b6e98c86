#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

/// What Teledyne's DVL formats (PD0, PD4, PD5, PD6) have in common: in which frame the velocities
/// are, and the way from there to the body. Source: Teledyne RDI, ADCP Coordinate Transformation,
/// P/N 951-6079-00. Everywhere here it is the vehicle that moves, not the bed.
namespace drydock::wire {

/// Axes of the velocities: beams 1 to 4; instrument X, Y, Z; ship starboard, forward, mast; earth
/// east, north, up. Except for beams the fourth component is the error velocity.
enum class DvlFrame : std::uint8_t { beam, instrument, ship, earth };
std::string_view to_string(DvlFrame frame);

using DvlComponents = std::array<std::optional<double>, 4>;  ///< m/s; empty: bad

/// How the head is built and set up.
struct DvlGeometry {
  std::optional<double> beam_angle_rad;  ///< from the vertical axis; empty: not told
  bool convex = true;
  bool faces_up = false;
  DvlFrame frame = DvlFrame::earth;
  bool tilts_used = false;           ///< ship and earth velocities are levelled with pitch and roll
  bool three_beam = false;           ///< a solution of three beams is allowed
  double heading_alignment_rad = 0;  ///< of beam 3 from the ship's bow, clockwise
};

/// What the instrument's own sensors read: bow up, starboard down positive.
struct DvlAttitude {
  std::optional<double> heading_rad, pitch_rad, roll_rad;
};

/// Velocity in the body axes of the instrument (x along the ship's bow as the heading alignment
/// says, y starboard, z down), from whatever frame the components are in:
///   beam        Janus geometry; one bad beam of four is bridged where the set-up allows it
///   instrument  turned by the heading alignment
///   ship        as it is, or levelled back to the body with pitch and roll when tilts were used
///   earth       turned back with heading, pitch and roll
/// Empty without bottom lock, for an upward-facing instrument, and where an angle that the way
/// needs is missing.
std::optional<std::array<double, 3>> velocity_frd(const DvlComponents& velocity,
                                                  const DvlGeometry& geometry,
                                                  const DvlAttitude& attitude);

/// Euler pitch of the head. The pitch sensor reads the tilt of the bow axis, which is more when the
/// head is heeled: tan(sensor) = tan(Euler) / cos(roll).
double euler_pitch(double sensor_pitch_rad, double roll_rad);

}  // namespace drydock::wire
