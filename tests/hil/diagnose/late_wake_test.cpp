#include <gtest/gtest.h>

#include "drivers/host/finding_log.hpp"
#include "estimators/host/diagnostician.hpp"

/// A diagnosis on a computer that wakes late.
namespace drydock::diagnose {
namespace late_wake_test {

using measurement::Stamp;
using namespace std::chrono_literals;

/// A compass at 50 Hz for two minutes. In the second one the computer is late by 15 ms twice a
/// second: the message of 5 ms later waits for it.
std::size_t findings(bool is_told) {
  rig_config::Rig rig;
  rig.devices.resize(1);
  auto& config = rig.devices.front();
  config.name = "compass";
  config.kind = measurement::Kind::attitude;
  config.protocol = "nmea0183";
  config.link = "pty:compass?baud=38400";
  config.rate_hz = 50;
  host::FindingLog log;
  host::Diagnostician diagnostician(rig, log);
  const Stamp start{1'000'000s};
  for (int i = 0; i < 6000; ++i) {
    const Stamp sent = start + i * 20ms;
    const bool late = i > 3000 && i % 25 == 0;
    const Stamp came = late ? sent + 10ms : sent;
    if (late && is_told) diagnostician.on_late_wake(sent - 5ms, came);
    measurement::AttitudeSample sample;
    sample.origin.received_at = sample.origin.valid_at = came;
    sample.heading_rad = 1e-3 * (i % 7);
    diagnostician.on_measurement(sample);
    if (i % 12 == 0) diagnostician.look(came);
  }
  return log.all().size();
}

TEST(DiagnosisOnABusyComputer, FindsNothingAmissIfItIsTold) {
  EXPECT_GT(findings(false), 0u);
  EXPECT_EQ(findings(true), 0u);
}

}  // namespace late_wake_test
}  // namespace drydock::diagnose
