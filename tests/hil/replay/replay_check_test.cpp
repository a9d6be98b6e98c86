// A replay is checked against the references of another replay.
#include <gtest/gtest.h>

#include "tests/hil/replay/recorded_run.hpp"

namespace replay_check_test {

using namespace recorded_run;

TEST_F(ReplayOfARun, MeetsItsOwnReference) {
  auto options = quiet("run.mcap");
  options.update_refs = file("refs.json");
  ASSERT_EQ(replayed(options).exit_code, 0);
  options.update_refs.clear();
  options.check = file("refs.json");
  const auto checked = replayed(options);
  EXPECT_EQ(checked.exit_code, 0);
  EXPECT_NE(checked.err.find("has it: "), std::string::npos) << checked.err;
}

TEST_F(ReplayOfARun, SaysWhereItFirstDivergesFromAReference) {
  auto options = quiet("run.mcap");
  options.update_refs = file("refs.json");
  options.refs_every = 1;
  ASSERT_EQ(replayed(options).exit_code, 0);
  options = quiet("other-seed.mcap");
  options.check = file("refs.json");
  const auto checked = replayed(options);
  EXPECT_EQ(checked.exit_code, 1);
  EXPECT_NE(checked.err.find("first divergence: /imu/data at "), std::string::npos) << checked.err;
  EXPECT_NE(checked.err.find("(message 1): angular_velocity.x: expected "), std::string::npos)
      << checked.err;
}

TEST_F(ReplayOfARun, RefusesAReferenceOfAnotherPart) {
  auto options = quiet("run.mcap");
  options.update_refs = file("refs.json");
  ASSERT_EQ(replayed(options).exit_code, 0);
  options.update_refs.clear();
  options.check = file("refs.json");
  options.part.only = {"dvl"};
  EXPECT_EQ(replayed(options).exit_code, 2);
}

}  // namespace replay_check_test
