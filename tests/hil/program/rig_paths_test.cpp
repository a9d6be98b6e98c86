// A rig is the same by whatever path it is named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/hil/program/program.hpp"

namespace rig_paths_test {

using program::drydock;
using program::Folder;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

/// rigs/, missions/, ... of the tree in a folder of their own, and a link to rigs/ elsewhere.
class RigPath : public testing::Test {
 protected:
  RigPath() {
    fs::copy(DRYDOCK_SOURCE_DIR "/rig_config", folder_ / "a", fs::copy_options::recursive);
    fs::create_directories(folder_ / "elsewhere/deep");
    fs::create_directory_symlink(folder_ / "a/rigs", folder_ / "elsewhere/deep/rigs");
  }
  Folder folder_;
};

TEST_F(RigPath, WithDotsAndBehindASymlinkIsRecordedWithAllItsFiles) {
  const auto dive = (folder_ / "dive.mcap").string();
  for (const std::string path :
       {"a/rigs/demo.toml", "./a/rigs/./demo.toml", "./../{}/a/rigs/demo.toml",
        "{/}/a/../a/rigs/demo.toml", "elsewhere/../a/rigs/demo.toml",
        "elsewhere/deep/rigs/demo.toml", "./elsewhere/deep/rigs/demo.toml"}) {
    const auto folder = (folder_ / "").parent_path();
    std::string rig = path;
    if (const auto at = rig.find("{}"); at != rig.npos)
      rig.replace(at, 2, folder.filename().string());
    if (const auto at = rig.find("{/}"); at != rig.npos) rig.replace(at, 3, folder.string());
    const auto run = drydock("run " + rig + " --for 1s --speed max --overwrite --record " + dive,
                             "cd " + folder.string() + ";");
    EXPECT_EQ(run.exit_code, 0) << rig << "\n" << run.output;
    EXPECT_THAT(drydock("replay --quiet " + dive).output, Not(HasSubstr("drivers only"))) << rig;
  }
}

TEST_F(RigPath, WithoutItsEndingIsThatFile) {
  fs::copy_file(folder_ / "a/rigs/demo.toml", folder_ / "my-rig.toml");
  EXPECT_THAT(drydock("run my-rig", "cd " + (folder_ / "").string() + ";").output,
              HasSubstr("my-rig.toml:11:11: /rig/mission: there is no file"));
}

TEST_F(RigPath, IsShownWithoutControlCharacters) {
  const auto name = (folder_ / "a\x1B[31m\nb.toml").string();
  std::ofstream(name) << "no rig\n";
  for (const std::string command : {"check", "info", "run"}) {
    const auto said = drydock(command + " '" + name + "'").output;
    EXPECT_THAT(said, Not(HasSubstr("\x1B"))) << command;
    EXPECT_THAT(said, HasSubstr("a?[31m?b.toml")) << command;
  }
}

}  // namespace rig_paths_test
