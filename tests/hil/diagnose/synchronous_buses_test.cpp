#include <gtest/gtest.h>

#include <random>

#include "drivers/host/finding_log.hpp"
#include "estimators/host/diagnostician.hpp"

/// Inertial units of several buses that all sample at the same instant.
namespace drydock::diagnose {
namespace synchronous_buses_test {

using measurement::Stamp;
using namespace std::chrono_literals;

constexpr std::size_t units = 6;  // at 100 Hz, three on each of two buses

rig_config::Rig two_buses_and_a_log() {
  rig_config::Rig rig;
  rig.devices.resize(units + 1);
  for (std::size_t i = 0; i < units; ++i) {
    auto& config = rig.devices[i];
    config.name = "imu" + std::to_string(i);
    config.kind = measurement::Kind::imu;
    config.protocol = "xsens";
    config.link = i < units / 2 ? "can:auto?name=a" : "can:auto?name=b";
    config.rate_hz = 100;
  }
  auto& log = rig.devices.back();
  log.name = "log";
  log.kind = measurement::Kind::emlog;
  log.protocol = "nmea0183";
  log.link = "pty:log?baud=4800";
  log.rate_hz = 5;
  return rig;
}

/// Between two samples of all units nothing comes for 10 ms. That is no computer that stood still.
TEST(DiagnosisOfSynchronousBuses, SeesThatAnotherDeviceLosesMessages) {
  const auto rig = two_buses_and_a_log();
  host::FindingLog findings;
  host::Diagnostician diagnostician(rig, findings);
  const Stamp start{1'000'000s};
  std::mt19937 random(1);
  std::bernoulli_distribution lost(0.3);
  for (int i = 0; i < 9000; ++i) {
    const Stamp at = start + i * 10ms;
    for (std::uint16_t device = 0; device < units; ++device) {
      measurement::ImuSample sample;
      sample.origin.device = device;
      sample.origin.received_at = sample.origin.valid_at = at;
      sample.specific_force = {0, 0, -9.8 + 1e-3 * static_cast<double>(random() % 100)};
      diagnostician.on_measurement(sample);
    }
    if (i % 20 != 0 || (i > 6000 && lost(random))) continue;
    measurement::WaterSpeed speed;
    speed.origin.device = units;
    speed.origin.received_at = speed.origin.valid_at = at;
    speed.longitudinal_mps = 1 + 1e-3 * static_cast<double>(random() % 100);
    diagnostician.on_measurement(speed);
  }
  ASSERT_EQ(findings.all().size(), 1u);
  EXPECT_EQ(findings.all().front().device, units);
  EXPECT_EQ(findings.all().front().cause, diagnosis::Cause::drop);
}

}  // namespace synchronous_buses_test
}  // namespace drydock::diagnose
