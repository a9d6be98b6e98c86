#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// A rig file as typed values. Names and units are those of the TOML keys; the JSON Schema
/// `rig_config/schema/rig.schema.json` says which are allowed, the loader fills in the defaults.
namespace drydock::rig_config {

enum class DeviceKind : std::uint8_t { dvl, emlog, gnss, imu, depth, actuator };

/// Whose axes PD4 and PD6 have.
enum class DvlMaker : std::uint8_t { teledyne, water_linked };

/// What is set on a Water Linked DVL when its link opens.
struct WaterLinkedConfig {
  std::optional<double> sound_speed_mps, mounting_rotation_rad;
  bool old_sentences = false;  ///< wrx and wrt too
};

/// How an emulated sensor errs. One standard deviation each; drawn or fixed as `bias_mode` says.
struct SensorErrors {
  std::array<double, 3> bias{};   ///< unit of the measured quantity, per axis
  std::array<double, 3> noise{};  ///< white, 1 sigma per sample
};

/// The satellites of an emulated receiver, where a broadcast ephemeris gives them.
struct SkyConfig {
  std::string ephemeris;                         ///< RINEX 2 or 3 GPS navigation file
  std::optional<std::int64_t> at_utc_ns;         ///< the sky of then, from the mission's start on
  std::array<double, 3> antenna_axis{0, 0, -1};  ///< boresight, unit vector in the body frame
  double boresight_cno_dbhz = 48;
  double power_noise = 0;       ///< 1 sigma of the power at each epoch, share of that at boresight
  double lowest_cno_dbhz = 20;  ///< below it nothing is tracked
  double elevation_mask_rad = 0.0872664625997165;  ///< 5 deg
};

struct EmulateConfig {
  bool fixed_bias = true;  ///< biases are +1 sigma as given; false: drawn N(0, 1 sigma) per seed
  double latency_s = 0;    ///< from sampling to the first byte on the wire
  SensorErrors primary;    ///< gyro rad/s, speed m/s, velocity m/s, pressure Pa, position m
  SensorErrors secondary;  ///< accelerometer m/s2, GNSS velocity m/s
  std::optional<SkyConfig> sky;  ///< kind gnss; empty: ten invented satellites
};

/// What an Aceinna IMU is set to; empty and zero: left as it is.
struct AceinnaConfig {
  int packet_rate_hz = 0;                                ///< 100 50 25 20 10 5 4 2
  std::string slope_message;                             ///< "on", "off": SSI2 beside ARI and ACCS
  int rate_filter_hz = -1, acceleration_filter_hz = -1;  ///< cut-off; -1: left, 0: off
  std::string orientation;  ///< "+X+Y+Z": the output's X, Y, Z as axes of the housing
};

/// Identifiers of an Xsens IMU that are not as delivered.
struct XsensConfig {
  bool extended = false;  ///< 29 bits
  struct Identifier {
    std::string message;  ///< as `drydock decode` names it: rate_of_turn, ...
    std::uint32_t id = 0;
  };
  std::vector<Identifier> identifiers;
};

/// How a CiA 404 pressure transmitter was set.
struct PressureConfig {
  std::string format = "integer+status", unit = "Pa";  ///< of TPDO1; object 6131h
  int decimals = 0;                                    ///< object 6132h
  bool gauge = false;                                  ///< 0 at the surface
};

struct DeviceConfig {
  std::string name;
  DeviceKind kind = DeviceKind::imu;
  /// nmea0183 ubx ubx+nmea0183 pd0 pd4 pd5 pd6 water-linked nortek aceinna cia404-imu epson-g550
  /// epson-g552 xsens nmea2000 cia404-pressure
  std::string protocol;
  std::string link;            ///< URI, see drivers/link/uri.hpp
  double rate_hz = 1;          ///< nominal; the emulated device keeps it, health compares with it
  double stale_after_s = 2;    ///< streaming -> stale
  double reopen_after_s = 10;  ///< stale -> backing off and opening again
  double latency_s = 0;        ///< stated by the protocol or the maker: subtracted from valid_at
  std::array<double, 3> lever_arm_m{};   ///< sensor in the body frame, from the vehicle's origin
  std::array<double, 3> mounting_rad{};  ///< roll, pitch, yaw of the sensor's axes against body
  int address = 0;                 ///< J1939 / NMEA 2000 source address or CANopen node; 0: any
  double heartbeat_timeout_s = 3;  ///< CANopen: a node silent for so long is lost
  bool sync = false;               ///< CANopen: samples on SYNC, which its driver sends at rate_hz
  double surface_pressure_pa = 101325, water_density_kgm3 = 1025;  ///< kind depth
  std::optional<double> unesco_latitude_rad;  ///< depth: of the standard ocean there instead
  AceinnaConfig aceinna;
  XsensConfig xsens;
  PressureConfig pressure;
  DvlMaker maker = DvlMaker::teledyne;            ///< kind dvl, PD4 and PD6
  std::optional<double> beam_angle_rad;           ///< kind dvl, PD4 and PD5 in beam coordinates
  std::optional<WaterLinkedConfig> water_linked;  ///< kind dvl, Water Linked serial
  EmulateConfig emulate;
  int line = 0;  ///< of the [[device]] block in the file
};

enum class LevelingFilter : std::uint8_t { robust, augmented, paper };

struct EstimatorConfig {
  std::string name;
  std::string kind;  ///< leveling
  LevelingFilter filter = LevelingFilter::robust;
  std::string imu, log;     ///< device names
  bool stationary = false;  ///< measurement model: all three velocities zero
  bool accelerometer_start =
      true;  ///< first attitude from the first specific force, not from `initial_*`
  double initial_roll_rad = 0, initial_pitch_rad = 0;
  double latitude_rad = 0, heading_rad = 0;
};

enum class LegKind : std::uint8_t { straight, turn, dive, s_path };

/// One leg of a kinematic mission, entered and left smoothly.
struct LegConfig {
  LegKind kind = LegKind::straight;
  double duration_s = 0;
  double turn_rad = 0;                     ///< turn: change of heading
  double depth_change_m = 0;               ///< dive: positive down
  double speed_mps = 0;                    ///< speed at the end of the leg
  double amplitude_rad = 0, period_s = 0;  ///< s_path: heading amplitude
  double roll_rad = 0;                     ///< heel held during a turn
};

/// A rolling airframe from burn-out to where it comes down.
struct BallisticConfig {
  double height_m = 0;                    ///< at burn-out, above the ellipsoid
  double ground_height_m = 0;             ///< of where it comes down
  double elevation_rad = 0;               ///< of the velocity at burn-out, above the horizon
  double ballistic_coefficient_kgm2 = 0;  ///< mass / (drag coefficient x area); 0: no air
  double roll_rate_radps = 0;             ///< held once spun up
  double roll_rad = 0;                    ///< at burn-out
  double spin_up_s = 0;                   ///< from no roll rate to the one held
  double angle_of_attack_rad = 0;         ///< of the nose's cone about the velocity
  double coning_radps = 0;                ///< rate at which the nose goes around it
};

struct MissionConfig {
  double latitude_rad = 0, longitude_rad = 0, depth_m = 0, heading_rad = 0, speed_mps = 0;
  double bed_depth_m = 100;
  std::array<double, 3> current_ned_mps{};
  std::vector<LegConfig> legs;               ///< repeated from the first when the run lasts longer
  std::optional<BallisticConfig> ballistic;  ///< in place of legs
};

struct Rig {
  std::string file, name;
  std::uint64_t seed = 1;
  std::int64_t start_utc_ns = 0;  ///< virtual time at which a lockstep run starts
  int dds_domain = 0;
  bool publish = true;            ///< put measurements, estimates and health on DDS
  double reorder_window_s = 0.2;  ///< pipeline: later measurements are counted and dropped
  MissionConfig mission;
  std::vector<DeviceConfig> devices;
  std::vector<EstimatorConfig> estimators;
};

}  // namespace drydock::rig_config
