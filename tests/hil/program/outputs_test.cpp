// No command writes over a file that it reads, nor over one that it cannot have written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/hil/program/program.hpp"

namespace outputs_test {

using program::drydock;
using program::Folder;
using testing::HasSubstr;
namespace fs = std::filesystem;

const fs::path dive = DRYDOCK_SOURCE_DIR "/fixtures/dives/dvl-finds-the-bottom/dive.mcap";

/// A recording and a rig of the user, and what they hold.
class Outputs : public testing::Test {
 protected:
  Outputs() {
    fs::copy_file(dive, recording_);
    fs::create_hard_link(recording_, folder_ / "link.mcap");
    fs::create_symlink(recording_, folder_ / "symlink.mcap");
    fs::copy_file(DRYDOCK_SOURCE_DIR "/rig_config/rigs/loop.toml", rig_);
  }

  /// What the program says when it refuses.
  std::string refused(const std::string& arguments) const {
    const auto said = drydock(arguments);
    EXPECT_EQ(said.exit_code, 2) << arguments << "\n" << said.output;
    EXPECT_EQ(program::read_file(recording_), program::read_file(dive)) << arguments;
    EXPECT_EQ(program::read_file(rig_),
              program::read_file(DRYDOCK_SOURCE_DIR "/rig_config/rigs/loop.toml"))
        << arguments;
    return said.output;
  }

  Folder folder_;
  const std::string recording_ = (folder_ / "dive.mcap").string(),
                    rig_ = (folder_ / "rig.toml").string();
};

TEST_F(Outputs, AreNeverTheInputWhateverItsNameIs) {
  const auto unlike = (folder_ / "." / "dive.mcap").string();
  for (const auto& name :
       {recording_, unlike, (folder_ / "link.mcap").string(), (folder_ / "symlink.mcap").string()})
    for (const std::string command :
         {"cut {} --from 1s --to 2s --overwrite -o ", "recover {} --overwrite -o ",
          "replay {} --quiet --overwrite --record ", "export {} --to pcapng --overwrite -o ",
          "bisect {} --run true --overwrite -o ", "track {} --overwrite -o ",
          "replay {} --quiet --json ", "replay {} --quiet --junit ",
          "replay {} --quiet --update-refs "}) {
      std::string words = command;
      words.replace(words.find("{}"), 2, recording_);
      EXPECT_THAT(refused(words + name), HasSubstr("is what RECORDING reads, and would be lost"));
    }
  EXPECT_THAT(refused("run " + rig_ + " --for 1s --speed max --json " + rig_),
              HasSubstr("--json: " + rig_ + " is what RIG reads"));
  EXPECT_THAT(refused("run " + rig_ + " --for 1s --speed max --overwrite --record " + rig_),
              HasSubstr("--record: " + rig_ + " is what RIG reads"));
  EXPECT_THAT(refused("twin " + recording_ + " --overwrite --rig " + rig_ + " -o " +
                      fs::path(rig_).parent_path().string()),
              HasSubstr("is what --rig reads"));
}

TEST_F(Outputs, WithoutOverwriteAreNoFilesOfAnotherKind) {
  for (const std::string option : {"--json ", "--junit "})
    for (const auto& file : {recording_, rig_})
      EXPECT_THAT(refused("run loop --for 1s --speed max " + option + file),
                  HasSubstr("and would be lost; name another file, or delete it first"));
}

TEST_F(Outputs, AreNoTomlFileThatBeginsWithATable) {
  const std::string own = (folder_ / "own.toml").string();
  for (const char* text : {"[rig]\nname = \"own\"\n", "[[fault]]\ndevice = \"dvl\"\n"}) {
    std::ofstream(own) << text;
    EXPECT_THAT(refused("run loop --for 1s --speed max --json " + own),
                HasSubstr("and would be lost; name another file, or delete it first"));
    EXPECT_EQ(program::read_file(own), text);
  }
}

TEST_F(Outputs, AreTwoFiles) {
  const auto one = (folder_ / "one.json").string();
  EXPECT_THAT(refused("run loop --for 1s --speed max --json " + one + " --junit " + one),
              HasSubstr("is what --junit writes"));
  EXPECT_EQ(drydock("run loop --for 1s --speed max --json /dev/null --junit /dev/null").exit_code,
            0);
}

TEST_F(Outputs, OfAnEarlierRunAreReplaced) {
  const auto one = (folder_ / "one.json").string();
  for (const int times : {1, 2})
    EXPECT_EQ(drydock("run loop --for 1s --speed max --json " + one).exit_code, 0) << times;
}

}  // namespace outputs_test
