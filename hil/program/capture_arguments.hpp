#pragma once

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "drivers/decode/decode.hpp"
#include "drivers/decode/replay.hpp"
#include "hil/program/look_of_capture.hpp"
#include "hil/replay/replay_rig.hpp"
#include "rig_config/file_trouble.hpp"
#include "rig_config/nearest_file.hpp"

namespace drydock::program {

/// Throws std::runtime_error with the reason where a file cannot be read, or where it is no MCAP
/// file though its name says so: a recording that lost its first bytes is no capture.
inline void must_be_readable(const std::string& file) {
  if (const auto why = rig_config::file_trouble(file); !why.empty())
    throw std::runtime_error(file + ": " + why + rig_config::nearest_file(file));
  if (file.ends_with(".mcap") && !replay::is_recording(file))
    throw std::runtime_error(file + ": byte 0: not an MCAP file");
  must_be_no_foreign_file(file);
}

/// The options of a capture without a rig, for commands that also take recordings.
inline void add_capture(CLI::App& sub, decode::ReplayOptions& capture) {
  const std::string group = "A capture without a rig";
  sub.add_option("--protocol", capture.protocol,
                 "what the sensor speaks: one of " + decode::decode_protocols())
      ->group(group);
  sub.add_option("--kind", capture.kind,
                 "one of dvl, emlog, gnss, imu, depth, actuator, attitude; where several speak the "
                 "protocol")
      ->group(group);
  sub.add_option("--baud", capture.baud, "of the recorded line, where the file holds bytes")
      ->group(group);
  sub.add_option("--bitrate", capture.bitrate, "of the recorded CAN bus; default 250000")
      ->check(CLI::Range(10'000U, 1'000'000U))
      ->group(group);
  sub.add_option("--data-bitrate", capture.data_bitrate,
                 "of the data phase of its CAN FD frames; default as --bitrate")
      ->check(CLI::Range(10'000U, 8'000'000U))
      ->group(group);
  sub.add_option(
         "--format", capture.format,
         "the file's format, where its content does not tell: one of " + decode::decode_formats())
      ->group(group);
  sub.add_option("--clock", capture.clock,
                 "of a capture without times of arrival: device (its own time, where it tells one; "
                 "the default) or line (bytes at --baud)")
      ->check(CLI::IsMember({"device", "line"}))
      ->group(group);
  sub.add_option("--interface", capture.interface, "of a CAN capture; default all")->group(group);
  sub.add_option("--address", capture.address, "on the bus; default the first seen")->group(group);
}

}  // namespace drydock::program
