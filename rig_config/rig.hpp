#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drivers/measurement/kind.hpp"
#include "rig_config/emulate.hpp"
#include "rig_config/expect.hpp"
#include "rig_config/fault.hpp"
#include "rig_config/mission.hpp"
#include "rig_config/vehicle.hpp"

/// A rig file as typed values. The names are those of the TOML keys. The JSON Schema
/// `rig_config/schema/rig.schema.json` defines the allowed values; the loader fills in the
/// defaults.
namespace drydock::rig_config {

using DeviceKind = measurement::Kind;
using measurement::DvlMaker;

/// The settings that a Water Linked DVL gets when its link opens.
struct WaterLinkedConfig {
  std::optional<double> sound_speed_mps, mounting_rotation_rad;
  bool old_sentences = false;  ///< send wrx and wrt too
};

/// The settings that an Aceinna IMU gets. Empty or zero: the setting does not change.
struct AceinnaConfig {
  int packet_rate_hz = 0;                                ///< 100 50 25 20 10 5 4 2
  std::string slope_message;                             ///< "on", "off": SSI2 beside ARI and ACCS
  int rate_filter_hz = -1, acceleration_filter_hz = -1;  ///< cut-off; -1: unchanged, 0: off
  std::string orientation;  ///< "+X+Y+Z": X, Y, Z of the output as axes of the housing
};

/// Identifiers of an Xsens IMU that differ from the default ones.
struct XsensConfig {
  bool extended = false;  ///< 29 bits
  struct Identifier {
    std::string message;  ///< its name in `drydock decode`: rate_of_turn, ...
    std::uint32_t id = 0;
  };
  std::vector<Identifier> identifiers;
};

/// The settings of a CiA 404 pressure transmitter.
struct PressureConfig {
  std::string format = "integer+status", unit = "Pa";  ///< of TPDO1; object 6131h
  int decimals = 0;                                    ///< object 6132h
  bool gauge = false;                                  ///< 0 at the surface
};

struct DeviceConfig {
  std::string name;
  DeviceKind kind = DeviceKind::imu;
  std::string protocol;  ///< a name of drivers/wire/registry.hpp with this kind
  std::string link;      ///< URI, see drivers/link/uri.hpp
  double rate_hz = 1;    ///< nominal: the rate of the emulated device, and the reference for health
  double stale_after_s = 2;              ///< streaming -> stale
  double reopen_after_s = 10;            ///< stale -> backing off and opening again
  double latency_s = 0;                  ///< from protocol or maker; it is subtracted from valid_at
  std::array<double, 3> lever_arm_m{};   ///< from the vehicle's origin to the sensor, body frame
  std::array<double, 3> mounting_rad{};  ///< roll, pitch, yaw from the body to the sensor's axes
  int address = 0;                 ///< J1939 / NMEA 2000 source address or CANopen node; 0: any
  double heartbeat_timeout_s = 3;  ///< CANopen: a node that is silent for longer is lost
  bool sync = false;               ///< CANopen: samples on SYNC; the driver sends it at rate_hz
  double surface_pressure_pa = 101325, water_density_kgm3 = 1025;  ///< kind depth
  std::optional<double>
      unesco_latitude_rad;  ///< kind depth: use the standard ocean at this latitude
  bool means = false;       ///< kind imu: samples are means over their interval
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

enum class MixingType : std::uint8_t { compensated, type1, type2, type3 };

/// The antenna, receiver and gyro of a roll estimator. All sigmas are one standard deviation.
struct RollConfig {
  std::array<double, 3> antenna_axis{0, 0, 1};  ///< boresight, unit vector in the body frame
  double boresight_cno_dbhz = 48;
  double lowest_cno_dbhz = 20;            ///< the lowest C/N0 that the receiver reports
  double cno_resolution_db = 1;           ///< on the wire
  double power_noise = 0.1;               ///< of the power at each epoch, relative to boresight
  double angular_random_walk = 1.745e-4;  ///< of the roll gyro, rad per sqrt(s): 0.6 deg/sqrt(h)
  double gyro_bias_radps = 0.0174532925199433;
  double angle_of_attack_rad = 0.00872664625997165;  ///< between body x and the velocity
};

enum class VelocityMethod : std::uint8_t { coupled, paper };

/// An inertial navigation: its start, and the errors of its sensors and its vehicle. 1 sigma.
struct InertialConfig {
  std::string dvl, depth, actuators;  ///< device names
  VelocityMethod method = VelocityMethod::coupled;
  double gate_sigma = 5, sea_level_m = 0;

  double latitude_rad = 0, longitude_rad = 0, depth_m = 0;
  std::array<double, 3> velocity_ned_mps{};
  double roll_rad = 0, pitch_rad = 0, heading_rad = 0;
  double position_sigma_m = 10, depth_sigma_m = 1, velocity_sigma_mps = 0.1;
  double tilt_sigma_rad = 0, heading_sigma_rad = 0;

  EmulateConfig imu_grade, dvl_grade, log_grade, depth_grade;  ///< from the sensor file
  std::optional<VehicleConfig> vehicle;                        ///< kind velocity
};

struct EstimatorConfig {
  std::string name;
  std::string kind;  ///< leveling, mixing, roll, navigation, velocity
  LevelingFilter filter = LevelingFilter::robust;
  std::string imu, log, gnss;  ///< device names
  RollConfig roll;
  bool stationary = false;  ///< measurement model: all three velocities zero
  bool accelerometer_start =
      true;  ///< true: first attitude from the first specific force; false: from `initial_*`
  double initial_roll_rad = 0, initial_pitch_rad = 0;
  double latitude_rad = 0, heading_rad = 0;
  MixingType mixing_type = MixingType::compensated;
  InertialConfig inertial;  ///< navigation, velocity
  double pivot_m = 0;       ///< mixing: point without side slip, ahead of the origin; 0: unknown
};

struct Rig {
  std::string file, name;
  std::vector<std::string> files;  ///< all files read: the rig file, then those that it names
  std::uint64_t seed = 1;
  std::int64_t start_utc_ns = 0;  ///< virtual time at the start of a lockstep run
  int dds_domain = 0;
  std::string dds_interface = "lo";  ///< network interface of the bus
  bool publish = true;               ///< publish measurements, estimates and health on DDS
  double reorder_window_s = 0.2;     ///< pipeline: later measurements are counted and dropped
  MissionConfig mission;
  std::vector<DeviceConfig> devices;
  std::vector<EstimatorConfig> estimators;
  std::vector<ExpectConfig> expects;
  std::vector<FaultConfig> faults;  ///< of the rig file, then of its mission
};

}  // namespace drydock::rig_config
