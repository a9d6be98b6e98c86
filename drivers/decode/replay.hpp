#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>

#include "drivers/device/driver_options.hpp"
#include "drivers/device/health_account.hpp"
#include "drivers/measurement/measurement.hpp"
#include "drivers/shell/recording_clock.hpp"

namespace drydock::decode {

struct ReplayOptions {
  std::string capture;        ///< file name
  std::string protocol;       ///< protocol of the sensor, or the name of `description`
  std::string kind;           ///< kind of the sensor; empty if only one kind speaks the protocol
  std::string speed = "max";  ///< max: at once, in virtual time; 1: real time; or another factor
  std::string format;         ///< empty: recognised by content
  std::string clock;          ///< device, line; empty: as the capture has it
  std::string interface;      ///< interface in a CAN capture; empty: all
  unsigned baud = 0;          ///< rate of a byte capture's line; 0: not known
  unsigned bitrate = 0;       ///< of a CAN capture's bus; 0: as `driver` has it, else 250000
  unsigned data_bitrate = 0;  ///< of its CAN FD frames' data phase; 0: likewise, else as `bitrate`
  std::uint8_t address = 0;   ///< on a CAN bus; 0: the first seen
  std::shared_ptr<const wire::described::Description> description{};  ///< null: of the registry
  /// As a rig describes the sensor. Empty: its protocol and kind alone are known.
  std::optional<device::DriverOptions> driver{};
  bool quiet = false;  ///< no states and totals on `err`
};

/// `drydock replay`: plays a capture through a driver and writes its measurements on `out` as JSON
/// Lines. Exit code: 0 there were measurements, 1 there were none, 2 there is no such driver or the
/// capture cannot be read.
int replay(const ReplayOptions& options, std::FILE* out, std::FILE* err);

/// The kind of sensor that the options mean. Throws std::invalid_argument with one line if there is
/// none or more than one.
device::Kind kind_of(const ReplayOptions& options);

using MeasurementHook = std::function<void(const measurement::Measurement&)>;

struct Played {
  device::Kind kind = device::Kind::dvl;
  shell::RecordingClock clock;    ///< that the times of the measurements come from
  device::HealthAccount account;  ///< of the driver at the end of the capture
};

/// Does the same for a program: in virtual time, with each measurement to `hook`. Throws
/// std::exception with one line if there is no such driver or the capture cannot be read.
Played play(const ReplayOptions& options, const MeasurementHook& hook);

}  // namespace drydock::decode
