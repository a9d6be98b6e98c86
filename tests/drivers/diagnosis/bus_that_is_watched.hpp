#pragma once

#include <gtest/gtest.h>

#include "drivers/diagnosis/monitors/bus_monitor.hpp"
#include "drivers/wire/j1939/j1939.hpp"
#include "tests/drivers/diagnosis/signs.hpp"

namespace drydock::diagnosis {

constexpr std::uint16_t depth = 0, rudder = 1;

inline wire::CanFrame frame_of(std::uint32_t id, bool extended, std::uint8_t size = 8) {
  wire::CanFrame frame;
  frame.id = id;
  frame.extended = extended;
  frame.size = size;
  return frame;
}

/// Two nodes of NMEA 2000 at 250 kbit/s, ten frames a second each, 40 s long.
struct BusThatIsWatched : testing::Test {
  BusThatIsWatched() {
    for (int i = 0; i < 400; ++i) tenth();
  }
  static Expected node(std::uint16_t device, std::uint8_t address) {
    Expected expected{.device = device, .nominal_rate_hz = 10};
    expected.protocol.travels = wire::Travels::as_frames;
    expected.protocol.network = wire::Network::j1939;
    expected.address = address;
    return expected;
  }
  static std::uint32_t id(std::uint32_t pgn, std::uint8_t source) {
    return wire::j1939::make_identifier({.pgn = pgn, .source = source});
  }
  void take(wire::CanFrame frame, double after_s = 0) {
    frame.data[0] = ++count;
    monitor.take(frame, at_s(now + after_s));
  }
  void tenth() {
    now += 0.1;
    take(frame_of(id(127'257, 35), true));
    take(frame_of(id(127'245, 36), true), 0.001);
    monitor.look(at_s(now + 0.002));
  }
  Signs signs;
  BusMonitor monitor{{node(depth, 35), node(rudder, 36)}, signs};
  double now = 0;
  std::uint8_t count = 0;
};

}  // namespace drydock::diagnosis
