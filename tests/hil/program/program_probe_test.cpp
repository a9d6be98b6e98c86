// The command `probe` on emulated links and on recordings.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/hil/program/program.hpp"

namespace program_probe_test {

using program::drydock;
using program::emulated_demo;
using program::Folder;
using testing::HasSubstr;
using testing::Not;

TEST(Program, AProbeFindsAnEmulatedSensorAndItsBlockIsAGoodRig) {
  const Folder folder;
  const auto outcome = drydock(emulated_demo + "probe pty:dvl --for 8s --json");
  const auto found = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(found["confidence"], "certain");
  EXPECT_EQ(found["attempts"][0]["findings"][0]["protocol"], "pd0");
  ASSERT_EQ(found["devices"].size(), 1u);
  EXPECT_EQ(found["devices"][0]["kind"], "dvl");
  EXPECT_NEAR(found["devices"][0]["rate_hz"], 5, 0.3);
  std::ofstream(folder / "rig.toml") << "[rig]\nname = \"probed\"\n"
                                     << found["devices"][0]["block"].get<std::string>();
  EXPECT_EQ(drydock("check " + (folder / "rig.toml").string()).exit_code, 0);
}

TEST(Program, AProbeOfAnEmulatedBusFindsDepthAndActuators) {
  const auto outcome = drydock(emulated_demo + "probe 'can:auto?name=drydock0' --for 4s --json");
  const auto found = nlohmann::json::parse(outcome.output);
  std::string kinds;
  for (const auto& device : found["devices"])
    kinds += device["kind"].get<std::string>() + device["address"].dump() + " ";
  EXPECT_EQ(kinds, "depth35 actuator36 ");
}

TEST(Program, AProbeOfARecordingNeedsNoTime) {
  const auto bytes = drydock("probe 'file:fixtures/pd0/golden.pd0?baud=115200'");
  EXPECT_EQ(bytes.exit_code, 0);
  EXPECT_THAT(bytes.output, HasSubstr("protocol = \"pd0\""));
  EXPECT_THAT(bytes.output,
              Not(HasSubstr(" Hz")));  // its clock does not step, and no line is asked
  const auto frames = drydock("probe file:fixtures/nmea2000/frames.log");
  EXPECT_EQ(frames.exit_code, 0);
  EXPECT_THAT(frames.output, HasSubstr("protocol = \"nmea2000\""));
  EXPECT_EQ(drydock("probe file:/dev/null").exit_code, 1);
  const Folder folder;
  const std::string comment = (folder / "comment").string();
  std::ofstream(comment) << "# a\n";
  EXPECT_THAT(drydock("probe file:" + comment).output, HasSubstr("the line: 0 bytes"));
  EXPECT_THAT(drydock("probe file:" + comment).output, HasSubstr("no bytes but comments"));
  const auto raw = drydock("probe 'file:" + comment + "?format=raw'");
  EXPECT_THAT(raw.output, HasSubstr("the line: 4 bytes"));
  EXPECT_EQ(drydock("probe serial:/dev/nowhere").exit_code, 1);
  EXPECT_EQ(drydock("probe").exit_code, 2);
}

}  // namespace program_probe_test
