#pragma once

#include <Eigen/Core>
#include <array>
#include <boost/container/static_vector.hpp>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "drivers/measurement/stamp.hpp"

/// Measurements of the sensors, in SI units and radians, body frame FRD (x forward, y starboard, z
/// down), navigation frame NED. A value that the device did not give is an empty optional.
namespace drydock::measurement {

enum class Provenance : std::uint8_t { real, emulated, replayed };

constexpr std::string_view to_string(Provenance provenance) {
  constexpr std::array<std::string_view, 3> names{"real", "emulated", "replayed"};
  return names[static_cast<std::size_t>(provenance)];
}

/// Source and time of a measurement. Drivers fill it; no later code changes it.
struct Origin {
  Stamp valid_at{};     ///< when the value was true, corrected for wire time and stated latency
  Stamp received_at{};  ///< arrival of its last byte or frame
  std::optional<std::chrono::nanoseconds> device_time;  ///< the device's own time and epoch
  Provenance provenance = Provenance::real;
  std::uint16_t device = 0;  ///< index of the device in the rig
};

/// Inertial measurement of one instant. The mounting has already rotated it into the body frame.
struct ImuSample {
  Origin origin;
  Eigen::Vector3d specific_force = Eigen::Vector3d::Zero();  ///< m/s2, body
  Eigen::Vector3d angular_rate = Eigen::Vector3d::Zero();    ///< rad/s, body against inertial
};

struct DepthSample {
  Origin origin;
  std::optional<double> depth_m;        ///< depth of the sensor below the surface, positive down
  std::optional<double> pressure_pa;    ///< absolute
  std::optional<double> temperature_k;  ///< of the water
  std::optional<double> altitude_m;     ///< height of the transducer above the bed (echo sounder)
};

/// DVL: velocity of the vehicle over the bed (bottom track).
struct BottomVelocity {
  Origin origin;
  std::optional<Eigen::Vector3d> velocity;                 ///< m/s, body; empty without bottom lock
  std::optional<double> error_velocity_mps;                ///< disagreement of the four beams
  std::optional<double> altitude_m;                        ///< vertical distance to the bed
  std::array<std::optional<double>, 4> range_m;            ///< per beam, vertical component
  std::optional<double> heading_rad, pitch_rad, roll_rad;  ///< the DVL's own attitude sensors
  std::optional<double> sound_speed_mps;
  /// Of the head: its own sensors' or what it was told; not on DDS.
  std::optional<double> depth_m, water_temperature_k, salinity_ppt;
  /// (m/s)2, body: as the DVL says, else from the rig's sigma. Error velocity is no accuracy.
  std::optional<Eigen::Matrix3d> velocity_covariance;
  std::optional<double> figure_of_merit_mps;  ///< accuracy of the velocity, as the DVL states it
};

/// EM log: speed through the water. It never contains speed over ground.
struct WaterSpeed {
  Origin origin;
  std::optional<double> longitudinal_mps;  ///< body x, positive ahead
  std::optional<double> transverse_mps;    ///< body y, positive to starboard
  std::optional<double> distance_m;        ///< total distance through the water
  std::optional<double> sigma_mps;         ///< of each speed, from the rig: no log tells it
};

struct Geodetic {
  double latitude_rad = 0;
  double longitude_rad = 0;
};

enum class FixType : std::uint8_t { none, dead_reckoning, two_d, three_d, gnss_and_dr, time_only };

/// What makes a position better or worse than that of satellites alone.
enum class FixQuality : std::uint8_t {
  autonomous,
  differential,
  rtk_float,
  rtk_fixed,
  dead_reckoning
};

struct GnssFix {
  Origin origin;
  FixType type = FixType::none;
  std::optional<Stamp> utc;
  std::optional<Geodetic> position;  ///< WGS-84; empty unless the receiver calls it valid
  std::optional<double> ellipsoidal_height_m, mean_sea_level_height_m;
  std::optional<Eigen::Vector3d> velocity_ned;  ///< m/s
  /// One sigma. The horizontal one is radial: the root of the variance north plus that east, as
  /// u-blox's hAcc; axis_sigma_m() is that of an axis.
  std::optional<double> horizontal_accuracy_m, vertical_accuracy_m, speed_accuracy_mps;
  std::optional<double> position_dop;
  std::optional<int> satellites_used;
  /// Over ground. Receivers without a vertical velocity (NMEA 0183) give only these.
  std::optional<double> ground_speed_mps, course_rad;
  std::optional<FixQuality> quality;  ///< empty without a fix, or if the receiver does not tell it
};

enum class Constellation : std::uint8_t { gps, sbas, galileo, beidou, imes, qzss, glonass, navic };

struct Satellite {
  Constellation constellation = Constellation::gps;
  std::uint8_t number = 0;  ///< PRN or slot within the constellation
  std::optional<double> cno_dbhz;
  std::optional<double> elevation_rad, azimuth_rad;
  bool used = false;
};

struct GnssSatellites {
  Origin origin;
  boost::container::static_vector<Satellite, 96> satellites;
};

/// Feedback of the actuators. Each device reports the values that it has.
struct ActuatorState {
  Origin origin;
  std::optional<double> rudder_rad;       ///< turns to port if positive (N < 0), as in the paper
  std::optional<double> stern_plane_rad;  ///< nose down if positive (M < 0)
  std::optional<double> bow_plane_rad;
  std::optional<double> propeller_radps;  ///< or of the thruster that this device drives
};

enum class HeadingReference : std::uint8_t { unknown, true_north, magnetic_north };

/// Compass, gyro or satellite compass: how the vehicle points and turns. Each message gives the
/// values that it has. Headings and rates are clockwise from above, headings in [0, 2 pi).
struct AttitudeSample {
  Origin origin;
  std::optional<double> heading_rad;  ///< of body x, against `reference`
  HeadingReference reference = HeadingReference::unknown;
  /// True = magnetic + deviation + variation, each positive to the east.
  std::optional<double> deviation_rad, variation_rad;
  std::optional<double> true_heading_rad;     ///< empty if the variation is not known
  std::optional<double> roll_rad, pitch_rad;  ///< of the body: starboard down, bow up
  std::optional<double> rate_of_turn_radps;   ///< rate of the heading
};

using Measurement = std::variant<ImuSample, DepthSample, BottomVelocity, WaterSpeed, GnssFix,
                                 GnssSatellites, ActuatorState, AttitudeSample>;

inline const Origin& origin_of(const Measurement& m) {
  return std::visit([](const auto& x) -> const Origin& { return x.origin; }, m);
}

}  // namespace drydock::measurement
