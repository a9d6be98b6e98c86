#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/measurement/kind.hpp"
#include "rig_config/emulate.hpp"
#include "rig_config/estimator/kinds.hpp"
#include "rig_config/expect.hpp"
#include "rig_config/fault.hpp"
#include "rig_config/mission.hpp"
#include "rig_config/places.hpp"

/// A rig file as typed values. The names are those of the TOML keys. The JSON Schema
/// `rig_config/schema/rig.schema.json` defines the allowed values; the loader fills in the
/// defaults.
namespace drydock::wire {
struct Protocol;
namespace described {
struct Description;
}
}  // namespace drydock::wire

namespace drydock::rig_config {

using DeviceKind = measurement::Kind;
using measurement::DvlMaker;

/// The settings that a Water Linked DVL gets when its link opens.
struct WaterLinkedConfig {
  std::optional<double> sound_speed_mps, mounting_rotation_rad;
  bool old_sentences = false;  ///< send wrx and wrt too; serial only
  std::string range_mode{};    ///< auto, =2, 1<=3; empty: unchanged
  std::optional<bool> acoustic_enabled{}, periodic_cycling{};
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

/// The settings that a u-blox receiver gets when its link opens. What is not named stays.
struct UbloxConfig {
  std::optional<double> rate_hz;  ///< of measurements
  struct Message {
    std::string name;  ///< NAV-PVT, GGA, ...: wire::ubx::message_names
    int epochs = 0;    ///< it comes each so many epochs; 0: never
  };
  std::vector<Message> messages;
};

/// How a DVL's speed of sound is put right.
struct SoundSpeedConfig {
  std::string source = "as-sent", equation = "mackenzie";
  double mps = 1500;
  std::optional<double> salinity_ppt, temperature_k, depth_m, set_mps;
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
  std::string protocol;  ///< a name of drivers/wire/registry.hpp with this kind, or a description's
  std::shared_ptr<const wire::described::Description> description;  ///< null: of the registry
  std::string link;    ///< URI, see drivers/link/uri.hpp
  double rate_hz = 1;  ///< nominal: the rate of the emulated device, and the reference for health
  double stale_after_s = 2;              ///< streaming -> stale
  double reopen_after_s = 10;            ///< stale -> backing off and opening again
  double latency_s = 0;                  ///< from protocol or maker; it is subtracted from valid_at
  std::array<double, 3> lever_arm_m{};   ///< from the vehicle's origin to the sensor, body frame
  std::array<double, 3> mounting_rad{};  ///< roll, pitch, yaw from the body to the sensor's axes
  int address = 0;  ///< J1939 / NMEA 2000 source address or CANopen node; 0: any
  std::optional<int>
      instance;  ///< NMEA 2000: of the engine or the pressure; empty: the first heard
  double heartbeat_timeout_s = 3;  ///< CANopen: a node that is silent for longer is lost
  bool sync = false;               ///< CANopen: samples on SYNC; the driver sends it at rate_hz
  double surface_pressure_pa = 101325, water_density_kgm3 = 1025;  ///< kind depth
  std::optional<double>
      unesco_latitude_rad;  ///< kind depth: use the standard ocean at this latitude
  bool means = false;       ///< kind imu: samples are means over their interval
  AceinnaConfig aceinna;
  XsensConfig xsens;
  PressureConfig pressure;
  std::optional<double> velocity_sigma_mps;       ///< kind dvl, emlog: if the sensor tells none
  double speed_scale = 1;                         ///< kind emlog: shown over true speed
  std::array<double, 3> compass_error_rad{};      ///< kind attitude: constant, sine, cosine
  DvlMaker maker = DvlMaker::teledyne;            ///< kind dvl, PD4 and PD6
  std::optional<double> beam_angle_rad;           ///< kind dvl, PD4 and PD5 in beam coordinates
  std::optional<bool> levelled;                   ///< kind dvl, ship axes; empty: as the DVL says
  std::optional<bool> velocity_of_bed;            ///< kind dvl, Wayfinder, AD2CP; empty: not known
  SoundSpeedConfig sound_speed;                   ///< kind dvl
  std::optional<WaterLinkedConfig> water_linked;  ///< kind dvl, Water Linked
  UbloxConfig ublox;                              ///< kind gnss, UBX
  EmulateConfig emulate;
  int line = 0;  ///< of the [[device]] block in the file
};

/// The facts of the device's protocol, of the registry or described. Null: there is no such one.
const wire::Protocol* protocol_of(const DeviceConfig& device);

struct EstimatorConfig {
  std::string name;
  std::string imu;  ///< device name; empty: of a kind without an IMU
  EstimatorKind kind;
};

struct Rig {
  std::string file, name;
  std::vector<std::string> files;  ///< all files read: the rig file, then those that it names
  std::uint64_t seed = 1;
  std::int64_t start_utc_ns = 0;  ///< virtual time at the start of a lockstep run
  int dds_domain = 0;
  std::string dds_interface = "lo";  ///< network interface of the bus
  bool publish = true;               ///< publish measurements, estimates and health on DDS
  bool truth = false;                ///< publish the truth of the emulated vehicle on DDS
  double reorder_window_s = 0.2;     ///< pipeline: later measurements are counted and dropped
  MissionConfig mission;
  std::vector<DeviceConfig> devices;
  std::vector<EstimatorConfig> estimators;
  std::vector<ExpectConfig> expects;
  std::vector<FaultConfig> faults;  ///< of the rig file, then of its mission
  PlacesPtr places;                 ///< of the rig file; empty for a rig that no file describes
};

}  // namespace drydock::rig_config
