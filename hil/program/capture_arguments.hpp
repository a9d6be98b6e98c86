#pragma once

#include <CLI/CLI.hpp>

#include "drivers/decode/decode.hpp"
#include "drivers/decode/replay.hpp"

namespace drydock::program {

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
