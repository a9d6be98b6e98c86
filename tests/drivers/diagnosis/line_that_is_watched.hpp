#pragma once

#include <gtest/gtest.h>

#include "drivers/diagnosis/monitors/line_monitor.hpp"
#include "tests/drivers/diagnosis/signs.hpp"

namespace drydock::diagnosis {

/// A device on a serial line at 10 Hz, looked at four times a second.
struct LineThatIsWatched : testing::Test {
  LineThatIsWatched() {
    health.state = device::State::streaming;
    health.since = health.last_message_at.emplace(at_s(0));
    health.link_up_since = at_s(0);
    for (int i = 0; i < 240; ++i) look(3);
  }
  /// A quarter of a second with so many frames.
  void look(unsigned frames) {
    now += 0.25;
    health.stream.frames += frames;
    health.stream.bytes_in += frames * 50;
    if (frames > 0) health.last_message_at = at_s(now);
    monitor.look(health, at_s(now));
  }
  Signs signs;
  LineMonitor monitor{{.kind = measurement::Kind::dvl, .nominal_rate_hz = 10}, signs};
  device::Health health;
  double now = 0;
};

}  // namespace drydock::diagnosis
