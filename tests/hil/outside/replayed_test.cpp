// A replay starts the program of a rig that the user names, and none of a rig in a recording.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hil/replay/replay_rig.hpp"
#include "tests/hil/outside/outside_rig.hpp"

namespace replayed_test {

using namespace outside_rig;
using testing::HasSubstr;

/// A recorded run of five seconds with a program, beside its rig.
void record(const Folder& folder) {
  std::ofstream(folder / "client.py") << client("{'roll_deg': 0.0, 'pitch_deg': 0.0}");
  std::ofstream(folder / "rig.toml") << one_imu + estimator("attitude");
  drydock::bench::RunOptions options;
  options.duration_s = 5;
  options.record.path = folder / "run.mcap";
  testing::internal::CaptureStdout();
  drydock::bench::run_lockstep(drydock::rig_config::load_rig(folder / "rig.toml").value(), options);
  testing::internal::GetCapturedStdout();
}

struct Said {
  int exit_code;
  std::string text;
};
Said replayed(const Folder& folder, const std::string& rig) {
  drydock::replay::RigReplayOptions options;
  options.recording = folder / "run.mcap";
  options.rig = rig;
  options.quiet = true;
  testing::internal::CaptureStdout();
  const int code = drydock::replay::replay_rig(options, stdin, stdout, stderr);
  return {code, testing::internal::GetCapturedStdout()};
}

TEST(OutsideReplayed, TheProgramOfANamedRigIsStartedAndJudged) {
  const Folder folder;
  record(folder);
  const auto said = replayed(folder, folder / "rig.toml");
  EXPECT_EQ(said.exit_code, 0) << said.text;
  EXPECT_THAT(said.text, HasSubstr("PASS mine answers: 100 to 100 steps"));
  EXPECT_THAT(said.text, testing::ContainsRegex("mine: [45][0-9][0-9] estimates"));
}

TEST(OutsideReplayed, AProgramThatFailsMakesTheReplayFail) {
  const Folder folder;
  record(folder);
  std::ofstream(folder / "client.py") << "raise SystemExit(3)\n";
  const auto said = replayed(folder, folder / "rig.toml");
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.text, HasSubstr("exited with code 3"));
}

TEST(OutsideReplayed, ThatOfARecordedRigIsNot) {
  const Folder folder;
  record(folder);
  const auto said = replayed(folder, "");
  EXPECT_EQ(said.exit_code, 0) << said.text;
  EXPECT_THAT(said.text, HasSubstr("mine: 0 estimates"));
  EXPECT_THAT(said.text,
              HasSubstr("mine: another program, which was not asked; run asks it, and so "
                        "does replay with --rig"));
}

}  // namespace replayed_test
