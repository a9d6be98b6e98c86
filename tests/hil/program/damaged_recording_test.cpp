// What a command makes of a recording of which a part is missing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstring>
#include <initializer_list>
#include <vector>

#include "tests/hil/program/program.hpp"

namespace damaged_recording_test {

using program::drydock;
using program::Folder;
using testing::HasSubstr;
namespace fs = std::filesystem;

class DamagedRecording : public testing::Test {
 protected:
  void SetUp() override {
    fs::copy(DRYDOCK_SOURCE_DIR "/rig_config", folder_ / "a", fs::copy_options::recursive);
    const auto rig = (folder_ / "a/rigs/demo.toml").string();
    std::ofstream(rig, std::ios::app)
        << "\n[[expect]]\nestimator = \"leveling\"\nestimates_min = 1\n";
    const auto run = drydock("run " + rig + " --for 6s --speed max --record " + dive_);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    bytes_ = program::read_file(dive_);
  }

  void write(const std::string& bytes) const { std::ofstream(dive_, std::ios::binary) << bytes; }

  Folder folder_;
  std::string dive_ = (folder_ / "dive.mcap").string(), bytes_;
};

TEST_F(DamagedRecording, IsNoPass) {
  EXPECT_EQ(drydock("replay --quiet --expect " + dive_).exit_code, 0);
  write(bytes_.substr(0, bytes_.size() / 2));
  const auto said = drydock("replay --quiet --expect " + dive_);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.output, HasSubstr("FAIL rig recording: damaged: byte"));
}

// The mission file in it has a wrong checksum, so nothing says what the estimators need.
TEST_F(DamagedRecording, WithoutTheFilesOfItsEstimatorsMeetsNoneOfTheirExpectations) {
  const auto mission = bytes_.find("[mission]");
  ASSERT_NE(mission, std::string::npos);
  bytes_[mission + 1] ^= 0x01;
  write(bytes_);
  const auto said = drydock("replay --quiet --expect " + dive_);
  EXPECT_EQ(said.exit_code, 1) << said.output;
  EXPECT_THAT(said.output, HasSubstr("FAIL leveling estimates: none: this estimator does not run"));
}

TEST_F(DamagedRecording, IsRecoveredBehindTheDamageToo) {
  std::vector<std::size_t> chunks;
  for (std::size_t at = 8; at + 9 < bytes_.size();) {
    std::uint64_t length = 0;
    std::memcpy(&length, bytes_.data() + at + 1, sizeof length);
    if (bytes_[at] == '\x06') chunks.push_back(at);
    at += 9 + length;
  }
  bytes_[chunks.at(chunks.size() / 2) + 60] ^= 0x10;
  write(bytes_);
  const auto saved = (folder_ / "saved.mcap").string();
  const auto said = drydock("recover " + dive_ + " -o " + saved);
  EXPECT_EQ(said.exit_code, 0);
  EXPECT_THAT(said.output, HasSubstr(" B left out"));
  EXPECT_THAT(said.output, HasSubstr("messages of 6.0 s"));
  EXPECT_EQ(drydock("info " + saved).exit_code, 0);
}

TEST_F(DamagedRecording, IsNoPipe) {
  const auto pipe = (folder_ / "pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const auto& command : std::initializer_list<std::string>{
           "info ", "replay ", "cut ", "recover ", "track ", "diff " + dive_ + " "}) {
    const auto said = drydock(command + pipe, "timeout 60");
    EXPECT_TRUE(said.exit_code == 1 || said.exit_code == 2) << command << said.exit_code;
  }
  EXPECT_THAT(drydock("diff " + dive_ + " " + pipe, "timeout 60").output,
              HasSubstr("is a device or a pipe, not a file"));
}

}  // namespace damaged_recording_test
