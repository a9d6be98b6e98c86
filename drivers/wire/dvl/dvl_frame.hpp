#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

/// Common part of Teledyne's DVL formats (PD0, PD4, PD5, PD6): the frames of the velocities, and
/// the conversion from them to the body. Source: Teledyne RDI, ADCP Coordinate Transformation, P/N
/// 951-6079-00. All velocities here are those of the vehicle, not of the bed.
namespace drydock::wire {

/// Axes of the velocities. beam: beams 1 to 4; instrument: X, Y, Z; ship: starboard, forward, mast;
/// earth: east, north, up. Except for beams the fourth component is the error velocity.
enum class DvlFrame : std::uint8_t { beam, instrument, ship, earth };
std::string_view to_string(DvlFrame frame);

using DvlComponents = std::array<std::optional<double>, 4>;  ///< m/s; empty: bad

/// Geometry and settings of the head.
struct DvlGeometry {
  std::optional<double> beam_angle_rad;  ///< from the vertical axis; empty: not known
  bool convex = true;
  bool faces_up = false;
  DvlFrame frame = DvlFrame::earth;
  bool tilts_used = false;           ///< ship and earth velocities are levelled with pitch and roll
  bool three_beam = false;           ///< a solution of three beams is allowed
  double heading_alignment_rad = 0;  ///< angle of beam 3 from the ship's bow, clockwise
};

/// Readings of the instrument's own sensors. Bow up and starboard down are positive.
struct DvlAttitude {
  std::optional<double> heading_rad, pitch_rad, roll_rad;
};

/// False if the head looks up and gives its own beams or axes: what it sees is not the bed. In ship
/// and earth axes an ensemble of an upward-facing head holds the bottom track of its twin that
/// looks down (a vehicle with two heads sends both in turn), and the head's own direction does not
/// matter.
constexpr bool is_of_the_bed(const DvlGeometry& head) {
  return !head.faces_up || head.frame == DvlFrame::ship || head.frame == DvlFrame::earth;
}

/// Velocity in the body axes of the instrument: x along the ship's bow by the heading alignment, y
/// starboard, z down. The components may be in any frame:
///  beam        Janus geometry; a single bad beam is replaced if the settings permit it
///  instrument  rotated by the heading alignment
///  ship        unchanged, or rotated back to the body with pitch and roll if tilts were used
///  earth       rotated back with heading, pitch and roll
/// Empty without bottom lock, if it is not of the bed, and if a required angle is missing.
std::optional<std::array<double, 3>> velocity_frd(const DvlComponents& velocity,
                                                  const DvlGeometry& geometry,
                                                  const DvlAttitude& attitude);

/// How little the beams agree: of beams d (b1 + b2 - b3 - b4) with d = 1 / (2 sqrt(2) sin of the
/// beam angle), so that it has the noise of a horizontal component; of other frames the fourth
/// component. Empty unless all four beams are there.
std::optional<double> error_velocity(const DvlComponents& sent, const DvlGeometry& geometry);

/// Euler pitch of the head. The pitch sensor reads the tilt of the bow axis. It reads more if the
/// head is heeled: tan(sensor) = tan(Euler) / cos(roll).
double euler_pitch(double sensor_pitch_rad, double roll_rad);

}  // namespace drydock::wire
