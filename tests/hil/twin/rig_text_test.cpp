#include "hil/twin/rig_text.hpp"

#include <gmock/gmock.h>

#include "rig_config/load.hpp"

namespace drydock::twin {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(EmulatedLink, KeepsTheRateOfTheLineAndTheBus) {
  EXPECT_EQ(emulated_link("serial:/dev/ttyUSB0?baud=115200&parity=even&dtr=0", "dvl", false),
            "pty:dvl?baud=115200&parity=even");
  EXPECT_EQ(emulated_link("serial:/dev/ttyUSB0?baud=auto", "dvl", false), "pty:dvl");
  EXPECT_EQ(emulated_link("tcp:192.168.2.95:16171", "a50", false), "pty:a50");
  EXPECT_EQ(emulated_link("file:dive.pd0?baud=9600", "dvl", false), "pty:dvl?baud=9600");
  EXPECT_EQ(emulated_link("file:can.log", "depth", true), "can:auto?name=canlog&bitrate=250000");
  EXPECT_EQ(emulated_link("socketcan:can0?bitrate=500000", "imu", true),
            "can:auto?name=can0&bitrate=500000");
  EXPECT_EQ(emulated_link("slcan:/dev/ttyACM0?bitrate=250000", "imu", true),
            "can:auto?name=ttyACM0&bitrate=250000");
  EXPECT_EQ(emulated_link("pty:dvl?baud=115200", "dvl", false), "pty:dvl?baud=115200");
}

constexpr const char* recorded_rig = R"(
[rig]
name = "boat"
start = 2020-01-01T00:00:00Z
mission = "old.toml"
[[device]]
name = "dvl"
kind = "dvl"
protocol = "pd0"
link = "serial:/dev/ttyUSB0?baud=38400"
rate_hz = 4
latency_ms = 50
lever_arm_m = [1, 0, 0.5]
emulate = { velocity_noise_mps = 0.3, boot_s = 2, head = { longest_range_m = 80, beam_noise_mps = 0.1 } }
[[estimator]]
name = "track"
kind = "dead-reckoning"
dvl = "dvl"
[[expect]]
device = "dvl"
reopens_max = 0
)";

TEST(TwinRigText, HasMeasuredErrorsInThePlaceOfStatedOnesAndKeepsTheRest) {
  TwinRig twin;
  twin.start = measurement::stamp_from_ns(1'418'990'000'123'456'789);  // 2014-12-19T11:53:20 UTC
  twin.devices = {{"dvl", "sensors/dvl.toml", 0.49}};
  twin.estimators = {"track"};
  const auto text = twin_rig_text(recorded_rig, twin);
  const auto rig =
      rig_config::load_rig_text(text, "rig.toml", {.link_check = {}, .devices_only = true}).value();
  EXPECT_NEAR(static_cast<double>(rig.start_utc_ns - 1'418'990'000'123'456'789), 0, 1000);
  const auto& dvl = rig.devices.at(0);
  EXPECT_EQ(dvl.link, "pty:dvl?baud=38400");
  EXPECT_EQ(dvl.rate_hz, 0.49);
  EXPECT_EQ(dvl.lever_arm_m[0], 1);
  EXPECT_THAT(text, HasSubstr("sensors/dvl.toml"));
  EXPECT_THAT(text, HasSubstr("boot_s = 2"));
  EXPECT_THAT(text, HasSubstr("longest_range_m = 80"));
  EXPECT_THAT(text, HasSubstr("mission.toml"));
  for (const char* gone : {"velocity_noise_mps", "beam_noise_mps", "old.toml", "reopens_max"})
    EXPECT_THAT(text, Not(HasSubstr(gone)));
  EXPECT_EQ(rig.estimators.size(), 1u);
}

}  // namespace
}  // namespace drydock::twin
