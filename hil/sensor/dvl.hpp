#pragma once

#include <array>
#include <optional>

#include "drivers/measurement/measurement.hpp"
#include "hil/motion/truth.hpp"
#include "hil/sensor/mounting.hpp"

/// A Doppler velocity log's ping: four Janus beams traced from the head against the ocean's bed and
/// through its water. docs/world/ocean.md has the equations by number.
namespace drydock::sensor {

/// Water against which a head measures too, as it counts: along its own axis.
struct WaterLayer {
  double start_m = 0, thickness_m = 0;
};

/// What a head can do. Beams are in PD0's order for one that looks down with beam 3 ahead: port,
/// starboard, forward, aft. Ranges are along the beam.
struct JanusHead {
  double beam_angle_rad = 0.5235987755982988;  ///< of each beam from the head's axis
  double shortest_range_m = 0.3, longest_range_m = 120;
  double absorption_dbpm = 0.16;  ///< of sound of its frequency in sea water
  int fewest_beams = 3;           ///< for a velocity; 3: error velocity taken as zero
  double fading_db = 0;           ///< 1 sigma of each echo's strength
  double beam_noise_mps = 0;      ///< 1 sigma of each beam's velocity
  std::optional<WaterLayer> layer = std::nullopt;
};

/// Signal over noise at which an echo is just found; so strong is it at the longest range.
inline constexpr double detection_snr_db = 8;

/// What differs from ping to ping: of each beam, to the bed and through the water.
struct PingNoise {
  std::array<double, 4> fade_db{}, bed_mps{}, water_mps{};
};

struct DvlPing : measurement::BottomVelocity {
  struct Beam {
    std::optional<double> range_m;       ///< along it; empty: no echo
    std::optional<double> velocity_mps;  ///< of the head along it, over the bed
    double snr_db = 0;                   ///< of the bed's echo; 0 without one
  };
  struct Water {
    std::optional<Eigen::Vector3d> velocity;  ///< m/s, through the layer's water, sensor's axes
    std::optional<double> error_velocity_mps;
    std::array<bool, 4> beam_good{};
  };
  std::array<Beam, 4> beams;
  Water water;
  double depth_m = 0, sound_speed = 0;  ///< at the head
};

/// Vectors are in the head's own axes; range_m is range * cos(beam angle), altitude_m what the head
/// makes of its ranges: its distance from a plane bed along its axis, times the cosine of its tilt.
DvlPing dvl_ping(const motion::Trajectory& trajectory, measurement::Stamp at,
                 const Mounting& mounting, const JanusHead& head, const PingNoise& noise = {});

/// Unit vectors along the beams, in the head's axes.
std::array<Eigen::Vector3d, 4> beam_directions(double beam_angle_rad);

}  // namespace drydock::sensor
