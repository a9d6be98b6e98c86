#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "rig_config/sensor_errors.hpp"

/// Emulated devices: errors of their sensors, and the sky over a receiver. The values come from a
/// rig file or a sensor file.
namespace drydock::rig_config {

/// The satellites of an emulated receiver from a broadcast ephemeris.
struct SkyConfig {
  std::string ephemeris;                         ///< RINEX 2 or 3 GPS navigation file
  std::optional<std::int64_t> at_utc_ns;         ///< time of the sky at the start of the mission
  std::array<double, 3> antenna_axis{0, 0, -1};  ///< boresight, unit vector in the body frame
  double boresight_cno_dbhz = 48;
  double power_noise = 0;       ///< 1 sigma of the power at each epoch, relative to boresight
  double lowest_cno_dbhz = 20;  ///< weaker signals are not tracked
  double elevation_mask_rad = 0.0872664625997165;  ///< 5 deg
};

/// Outages: bursts of samples that the device does not send (docs/sensors/errors.md, (15)).
struct DropoutConfig {
  double probability = 0;   ///< of the begin of an outage, at each sample outside an outage
  double mean_samples = 1;  ///< length of an outage
};

/// The head of an emulated DVL. Empty: the value of the maker. Ranges are along the beams.
struct DvlHeadConfig {
  std::optional<double> shortest_range_m, longest_range_m;
  std::optional<bool> three_beams;                  ///< three beams are enough for a velocity
  std::optional<double> sound_speed_mps;            ///< set to; empty: that of the water
  double fading_db = 1.5;                           ///< 1 sigma of each echo's strength
  double beam_noise_mps = 0;                        ///< 1 sigma of each beam's velocity
  double layer_start_m = 0, layer_thickness_m = 0;  ///< water track; thickness 0: none
};

/// Which u-blox generation an emulated receiver is: its messages, its settings and its versions.
enum class UbloxModel : std::uint8_t { m8, f9 };

/// An emulated compass.
struct CompassConfig {
  std::optional<double> variation_rad;  ///< positive to the east; empty: it knows none
  bool magnetic = false;                ///< its heading is from magnetic north
};

struct EmulateConfig {
  bool fixed_bias = true;  ///< true: constants are +1 sigma; false: drawn N(0, 1 sigma) per seed
  double latency_s = 0;    ///< from sampling to the first byte on the wire
  double boot_s = 0;       ///< from power-on to the first message
  std::string banner;      ///< sent after the boot; byte links
  double first_fix_s = 0;  ///< kind gnss: from power-on to the first fix, a cold start
  DropoutConfig dropout;

  /// Gyro rad/s, velocity or speed m/s, position m, pressure Pa, angle rad.
  SensorErrors primary;
  SensorErrors secondary;  ///< accelerometer m/s2, GNSS velocity m/s, shaft rad/s

  // Values of a sensor file for rigs that do not set them.
  std::optional<double> rate_hz;
  std::optional<double> power_noise;  ///< kind gnss: see SkyConfig

  std::optional<SkyConfig> sky;       ///< kind gnss; empty: ten invented satellites
  DvlHeadConfig head;                 ///< kind dvl
  CompassConfig compass;              ///< kind attitude
  UbloxModel model = UbloxModel::m8;  ///< kind gnss, UBX
};

}  // namespace drydock::rig_config
