#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "drivers/device/gnss/ublox_settings.hpp"
#include "drivers/device/mounting.hpp"
#include "drivers/measurement/kind.hpp"
#include "drivers/measurement/sound_speed.hpp"
#include "drivers/measurement/water_column.hpp"
#include "drivers/wire/can/xsens.hpp"
#include "drivers/wire/canopen/cia404_pressure.hpp"
#include "drivers/wire/j1939/aceinna_setup.hpp"
#include "drivers/wire/line_rate.hpp"

namespace drydock::wire::described {
struct Description;
}

namespace drydock::device {

using measurement::DvlMaker;
using measurement::Kind;

/// How a driver controls its CANopen node.
struct CanopenOptions {
  std::chrono::nanoseconds heartbeat_timeout = std::chrono::seconds{3};
  std::chrono::nanoseconds sync_period{0};  ///< the driver sends SYNC with this period; 0: never
};

/// Settings for an Aceinna IMU. An empty one is left unchanged.
struct AceinnaSettings {
  struct Filter {
    std::uint8_t rate_hz = 0, acceleration_hz = 0;  ///< cut-off frequencies
  };
  std::optional<std::uint8_t> rate_divider;  ///< divides 100 Hz
  std::optional<std::uint8_t> packets;       ///< wire::aceinna::PacketType
  std::optional<Filter> filter;
  std::optional<std::uint16_t> orientation;  ///< wire::aceinna::Axes::code

  bool any() const { return rate_divider || packets || filter || orientation; }
};

/// How to read the numbers of a pressure transmitter.
struct PressureOptions {
  wire::cia404_pressure::Scale scale;
  bool gauge = false;  ///< it reads 0 at the surface, not in vacuum
};

/// Settings for a Water Linked DVL, sent when its link opens. An empty one is left unchanged.
struct WaterLinkedSettings {
  std::optional<double> sound_speed_mps;
  std::optional<double> mounting_rotation_rad;  ///< the DVL itself applies it, about z
  bool old_sentences = false;                   ///< also wrx and wrt; serial only
  std::string range_mode{};                     ///< auto, =2, 1<=3, ... as the DVL names them
  std::optional<bool> acoustic_enabled{};       ///< false: it pings only on a trigger
  std::optional<bool> periodic_cycling{};       ///< it looks for other range modes every 10 s
};

/// The speed of sound that a DVL should have used, m/s.
struct SoundSpeedOptions {
  enum class Source : std::uint8_t { as_sent, fixed, computed };
  Source source = Source::as_sent;
  double fixed_mps = 1500;
  measurement::SoundSpeedEquation equation = measurement::SoundSpeedEquation::mackenzie;
  /// Computed; empty: as the DVL tells them.
  std::optional<double> salinity_ppt, temperature_k, depth_m;
  std::optional<double> set_mps;  ///< that the DVL used; empty: as it tells it
};

struct DvlOptions {
  DvlMaker maker = DvlMaker::teledyne;
  std::optional<double> beam_angle_rad;  ///< from the vertical; for protocols that do not give it
  /// Ship axes: true if the velocities come levelled with pitch and roll. Empty: as the DVL says.
  std::optional<bool> levelled;
  /// Wayfinder and AD2CP: true if it sends the bed's motion, not the vehicle's. Empty: not known.
  std::optional<bool> velocity_of_bed;
  SoundSpeedOptions sound_speed;
  std::optional<WaterLinkedSettings> water_linked;  ///< empty: the driver only listens
};

/// Everything that a driver needs to know about its sensor.
struct DriverOptions {
  Kind kind = Kind::imu;
  std::string protocol;  ///< one of protocols_of(kind), or the name of `description`
  std::shared_ptr<const wire::described::Description> description;  ///< null: of the registry
  std::chrono::nanoseconds poll_period = std::chrono::seconds{1};   ///< of a sensor that is asked
  std::uint16_t device = 0;  ///< index in the rig, part of every Origin
  Mounting mounting;
  std::chrono::nanoseconds latency{0};   ///< from the time of validity to the first bit on the wire
  std::optional<unsigned> baud;          ///< byte links; empty if there is no line rate
  wire::ByteFrame byte_frame;            ///< of a line with a rate
  unsigned bitrate = 250'000;            ///< rate of a CAN bus, bit/s
  std::optional<unsigned> data_bitrate;  ///< of the data phase of CAN FD; empty: as `bitrate`
  std::uint8_t address = 0;              ///< J1939 source address, CANopen node; 0: the first seen
  /// NMEA 2000: which of several engines or pressures of one sender; empty: the first heard.
  std::optional<std::uint8_t> instance;
  AceinnaSettings aceinna;
  CanopenOptions canopen;
  wire::xsens::Identifiers xsens_identifiers;
  measurement::WaterColumn water;            ///< kind depth
  PressureOptions pressure;                  ///< protocol cia404-pressure
  DvlOptions dvl;                            ///< kind dvl
  UbloxSettings ublox;                       ///< kind gnss, UBX; empty: the driver only listens
  std::optional<double> velocity_sigma_mps;  ///< kind dvl, emlog: if the sensor does not say it
  double speed_scale = 1;  ///< kind emlog: the speed that it shows over the true one
  /// Kind attitude: a, b, c. At the heading h the sensor shows h + a + b sin h + c cos h.
  std::array<double, 3> compass_error_rad{};
};

}  // namespace drydock::device
