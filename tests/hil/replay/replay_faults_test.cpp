// Faults are applied to a recording, as if its devices had had them.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/hil/replay/recorded_run.hpp"

namespace replay_faults_test {

using namespace recorded_run;

/// The times of a device's measurements of one type.
std::vector<double> times_of(const std::string& text, const std::string& device,
                             const std::string& type) {
  std::vector<double> times;
  for (const auto& line : lines_of(text))
    if (line.value("device", "") == device && line.value("type", "") == type)
      times.push_back(line["valid_at_s"]);
  return times;
}

class ReplayWithFaults : public ReplayOfARun {
 protected:
  static Replayed with(const std::string& faults, const std::string& only = "") {
    std::ofstream(file("faults.toml")) << faults;
    RigReplayOptions options;
    options.recording = file("run.mcap");
    options.faults = file("faults.toml");
    if (!only.empty()) options.part.only = {only};
    return replayed(options);
  }
  static Replayed sound() {
    RigReplayOptions options;
    options.recording = file("run.mcap");
    return replayed(options);
  }
};

TEST_F(ReplayWithFaults, ThatAreNoneIsTheReplayWithout) {
  EXPECT_EQ(with("fault = []\n").out, sound().out);
}

TEST_F(ReplayWithFaults, ThatNeverStrikeGivesEveryMeasurementAgainToTheLastDigit) {
  const auto replay = with(
      "[[fault]]\ndevice = \"dvl\"\nfault = \"drop\"\nprobability = 0.0\n"
      "[[fault]]\ndevice = \"gnss\"\nfault = \"flip\"\nprobability = 0.0\n"
      "[[fault]]\ndevice = \"imu\"\nfault = \"drop\"\nprobability = 0.0\n");
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
  EXPECT_EQ(replay.out, sound().out);
}

TEST_F(ReplayWithFaults, LosesTheDroppedMeasurementsAndNoOther) {
  const auto replay = with("[[fault]]\ndevice = \"dvl\"\nfault = \"drop\"\nprobability = 0.3\n");
  ASSERT_EQ(replay.exit_code, 0) << replay.err;
  const auto all = sound();
  const auto before = times_of(all.out, "dvl", "bottom_velocity");
  const auto after = times_of(replay.out, "dvl", "bottom_velocity");
  ASSERT_GT(before.size(), 50u);
  EXPECT_TRUE(std::ranges::includes(before, after));
  EXPECT_NE(replay.err.find("dvl: faults hit drop " + std::to_string(before.size() - after.size()) +
                            "\n"),
            std::string::npos)
      << before.size() << " " << after.size() << replay.err;
  EXPECT_EQ(times_of(replay.out, "imu", "imu"), times_of(all.out, "imu", "imu"));
  EXPECT_EQ(with("[[fault]]\ndevice = \"dvl\"\nfault = \"drop\"\nprobability = 0.3\n").out,
            replay.out);
}

TEST_F(ReplayWithFaults, CountsWrongChecksumsWhereTheDriverDoes) {
  const auto replay = with(
      "[[fault]]\ndevice = \"dvl\"\nfault = \"bad-checksum\"\nprobability = 1.0\n"
      "start_s = 5.0\nfor_s = 2.0\n",
      "dvl");
  const auto all = times_of(sound().out, "dvl", "bottom_velocity").size();
  const auto got = times_of(replay.out, "dvl", "bottom_velocity").size();
  EXPECT_NE(replay.err.find(std::to_string(all - got) + " bad checksums"), std::string::npos)
      << replay.err;
  EXPECT_NE(replay.err.find("bad-checksum " + std::to_string(all - got)), std::string::npos);
  EXPECT_GT(got, 0u);
  EXPECT_LT(got, all);
}

TEST_F(ReplayWithFaults, AnUnpluggedPortIsLostAndComesBack) {
  const auto replay =
      with("[[fault]]\ndevice = \"dvl\"\nfault = \"unplug\"\nstart_s = 5.0\nfor_s = 2.0\n", "dvl");
  EXPECT_NE(replay.err.find("the port is gone"), std::string::npos) << replay.err;
  EXPECT_NE(replay.err.find("unplug 1"), std::string::npos) << replay.err;
  EXPECT_LT(times_of(replay.out, "dvl", "bottom_velocity").size(),
            times_of(sound().out, "dvl", "bottom_velocity").size());
}

TEST_F(ReplayWithFaults, RefusesWhatOnlyAnEmulatedSensorDoesAndWhatIsNotPlayed) {
  const auto off = with("[[fault]]\ndevice = \"dvl\"\nfault = \"bottom-lost\"\n");
  EXPECT_EQ(off.exit_code, 2);
  EXPECT_NE(off.err.find("faults.toml:1:1: /fault: dvl \"dvl\""), std::string::npos) << off.err;
  EXPECT_NE(off.err.find("behind the wire is a recording"), std::string::npos) << off.err;
  const auto unknown = with("[[fault]]\ndevice = \"dvk\"\nfault = \"drop\"\n");
  EXPECT_NE(unknown.err.find("no device is named \"dvk\""), std::string::npos) << unknown.err;
  const auto silent = with("[[fault]]\ndevice = \"dvl\"\nfault = \"drop\"\n", "imu");
  EXPECT_EQ(silent.exit_code, 2);
  EXPECT_NE(silent.err.find("does not play"), std::string::npos) << silent.err;
}

}  // namespace replay_faults_test
