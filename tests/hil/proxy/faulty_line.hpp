#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>

#include "hil/fault/wire/faulty_stream.hpp"
#include "tests/hil/proxy/outlet.hpp"

/// A receiver whose bytes pass through faults, in virtual time.
namespace drydock::fault::testing {

inline DeviceConfig receiver(const std::string& protocol = "nmea0183") {
  DeviceConfig device;
  device.name = "gnss";
  device.kind = rig_config::DeviceKind::gnss;
  device.protocol = protocol;
  device.link = "serial:/dev/ttyUSB0?baud=9600";
  return device;
}

/// A device's line with its faults and the drivers' end. Time goes from deadline to deadline.
struct FaultyLine {
  explicit FaultyLine(const DeviceConfig& device = receiver())
      : schedule(std::make_shared<Schedule>(start)), stream(device, 7, schedule, start) {}

  void run_until(Stamp at) {
    for (auto due = stream.deadline(); due && *due <= at; due = stream.deadline()) {
      now = std::max(now, *due);
      stream.tick(now, heard);
    }
    now = at;
  }
  void say(std::string_view text, Stamp at) {
    run_until(at);
    stream.receive(bytes_of(text), at, heard);
  }

  std::shared_ptr<Schedule> schedule;
  FaultyStream stream;
  Heard heard;
  Stamp now = start;
};

}  // namespace drydock::fault::testing
