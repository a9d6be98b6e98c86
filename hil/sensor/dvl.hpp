#pragma once

#include <array>
#include <optional>

#include "drivers/measurement/measurement.hpp"
#include "hil/motion/truth.hpp"
#include "hil/sensor/mounting.hpp"

/// The ping of a Doppler velocity log: four Janus beams are traced from the head to the bed and
/// through the water. docs/world/ocean.md numbers the equations.
namespace drydock::sensor {

/// The water layer in which a head also measures. Lengths are along the head's axis.
struct WaterLayer {
  double start_m = 0, thickness_m = 0;
};

/// The properties of a head. Beams have the order of PD0 for a head that looks down with beam 3
/// ahead: port, starboard, forward, aft, all turned by `turn_rad`. Ranges are along the beam.
struct JanusHead {
  double beam_angle_rad = 0.5235987755982988;  ///< between each beam and the head's axis
  double turn_rad = 0;                         ///< of the beams about the head's axis, clockwise
  double shortest_range_m = 0.3, longest_range_m = 120;
  double absorption_dbpm = 0.16;  ///< absorption of sound at its frequency in sea water
  int fewest_beams = 3;           ///< for a velocity; 3: the error velocity is taken as zero
  double fading_db = 0;           ///< 1 sigma of the strength of each echo
  double beam_noise_mps = 0;      ///< 1 sigma of each beam's velocity
  std::optional<WaterLayer> layer = std::nullopt;
  /// The speed of sound that the head was set to, m/s; empty: it knows the true one. Velocities and
  /// ranges are in proportion to it.
  std::optional<double> set_sound_speed_mps = std::nullopt;
};

/// Signal-to-noise ratio at which an echo is just detected. An echo at the longest range has this
/// ratio.
inline constexpr double detection_snr_db = 8;

/// The random parts of one ping, per beam: echo strength, velocity to the bed and through the
/// water.
struct PingNoise {
  std::array<double, 4> fade_db{}, bed_mps{}, water_mps{};
};

struct DvlPing : measurement::BottomVelocity {
  struct Beam {
    std::optional<double> range_m;       ///< along the beam; empty: no echo
    std::optional<double> velocity_mps;  ///< head's velocity along the beam, over the bed
    double snr_db = 0;                   ///< the bed's echo; 0 without an echo
  };
  struct Water {
    std::optional<Eigen::Vector3d> velocity;  ///< m/s, through the water of the layer, sensor's
                                              ///< axes
    std::optional<double> error_velocity_mps;
    std::array<bool, 4> beam_good{};
  };
  std::array<Beam, 4> beams;
  Water water;
  double depth_m = 0, sound_speed = 0;  ///< at the head
};

/// Vectors are in the head's own axes. range_m is range * cos(beam angle). altitude_m is computed
/// by the head from its ranges: distance to a plane bed along its axis, times the cosine of its
/// tilt.
DvlPing dvl_ping(const motion::Trajectory& trajectory, measurement::Stamp at,
                 const Mounting& mounting, const JanusHead& head, const PingNoise& noise = {});

/// Unit vectors along the beams, in the head's axes.
std::array<Eigen::Vector3d, 4> beam_directions(const JanusHead& head);

}  // namespace drydock::sensor
