#include <gtest/gtest.h>

#include "drivers/host/finding_log.hpp"
#include "estimators/host/diagnostician.hpp"
#include "hil/summary/findings.hpp"

/// A diagnosis while somebody sets the host's clock.
namespace drydock::diagnose {
namespace clock_step_test {

using device::Device;
using measurement::Stamp;
using namespace std::chrono_literals;

struct Nobody final : device::Listener, device::Transmitter {
  void on_measurement(const measurement::Measurement&) override {}
  void on_state(const Device&, const device::Transition&) override {}
  void send(wire::Bytes) override {}
  void send(const wire::CanFrame&) override {}
};

/// A GNSS whose port is away, and its diagnosis 5 times a second.
struct Away {
  Away() {
    rig.devices.resize(1);
    auto& config = rig.devices.front();
    config.name = "gnss";
    config.kind = measurement::Kind::gnss;
    config.protocol = "nmea0183";
    config.link = "serial:/dev/nowhere?baud=4800";
    config.rate_hz = 1;
    device::DeviceOptions options;
    options.name = config.name;
    options.link = config.link;
    options.driver.kind = config.kind;
    options.driver.protocol = config.protocol;
    device = *Device::make(options);
    device->connect(nobody, nobody);
    diagnostician.emplace(rig, findings);
    diagnostician->watch({device.get()});
    device->start(now);
    device->open_failed(now, "No such file or directory");
  }
  void go_on(std::chrono::seconds time) {
    for (const Stamp end = now + time; now < end; now += 200ms) {
      device->tick(now);
      if (device->wants_open()) device->open_failed(now, "No such file or directory");
      diagnostician->look(now);
    }
  }

  rig_config::Rig rig;
  Nobody nobody;
  std::unique_ptr<Device> device;
  host::FindingLog findings;
  std::optional<host::Diagnostician> diagnostician;
  Stamp now{1'000'000s};
};

/// A stall is told with its times, and a wait that was said before is none.
TEST(DiagnosisAtAStall, TellsThatThisProgramStoodStill) {
  struct Stalls final : host::Follower {
    void on_stall(Stamp from, Stamp to) override { all.emplace_back(from, to); }
    std::vector<std::pair<Stamp, Stamp>> all;
  } stalls;
  Away away;
  away.diagnostician.emplace(away.rig, stalls);
  away.diagnostician->watch({away.device.get()});
  away.go_on(20s);
  const Stamp last = away.now - 200ms;
  away.now = last + 8s;
  away.go_on(20s);
  ASSERT_EQ(stalls.all.size(), 1u);
  EXPECT_EQ(stalls.all.front(), std::pair(last, last + 8s));
  away.now += 8s;
  away.diagnostician->await(away.now);
  away.go_on(20s);
  EXPECT_EQ(stalls.all.size(), 1u);
}

TEST(DiagnosisAtAClockStep, NoFindingLastsLongerThanItDid) {
  for (const auto step : {3600s, -3600s}) {
    Away away;
    const Stamp start = away.now;
    away.go_on(20s);
    ASSERT_EQ(away.findings.all().size(), 1u);
    away.now += step;
    away.device->clock_stepped(step, away.now);
    away.go_on(20s);
    const auto& all = away.findings.all();
    ASSERT_EQ(all.size(), 2u) << step.count();
    ASSERT_TRUE(all[0].until);
    EXPECT_GT(*all[0].until - all[0].since, 10s) << step.count();
    EXPECT_LT(*all[0].until - all[0].since, 21s) << step.count();
    EXPECT_FALSE(all[1].until) << "it is still away";
    EXPECT_GT(away.now - all[1].since, 10s) << step.count();
    EXPECT_LT(away.now - all[1].since, 41s) << step.count();
    const auto told = summary::accounts_of(away.findings, away.rig, start);
    EXPECT_NEAR(told[0].until_s.value_or(0), 20, 0.3) << "counted from the start of the run";
    EXPECT_GE(told[1].found_s, 20) << step.count();
    EXPECT_LT(told[1].found_s, 40) << step.count();
  }
}

}  // namespace clock_step_test
}  // namespace drydock::diagnose
