// The rig file inside a recording, unpacked.
#include <gtest/gtest.h>

#include <fstream>

#include "drivers/recordings/mcap/file_sink.hpp"
#include "drivers/recordings/record/recorder.hpp"
#include "hil/replay/rigs/recorded_rig.hpp"
#include "tests/hil/replay/recorded_run.hpp"

namespace recorded_rig_test {

using namespace recorded_run;

TEST_F(ReplayOfARun, LeavesNothingInTheTemporaryFolder) {
  auto recording = record::Recording::open(file("run.mcap")).value();
  fs::path folder;
  {
    const RecordedRig rig(recording);
    folder = rig.folder();
    EXPECT_TRUE(fs::exists(folder));
    EXPECT_EQ(rig.rig().mission.files.size() > 0 || rig.rig().files.size() > 1, true);
  }
  EXPECT_FALSE(fs::exists(folder));
}

TEST(RecordedRig, WithoutTheFilesOfItsWorldHasItsDriversAndSaysWhatIsMissing) {
  const fs::path path = fs::temp_directory_path() / ("rig-" + std::to_string(::getpid()));
  std::ifstream demo(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml");
  record::RecorderOptions options;
  options.attachments = {{0, 0, "rig.toml", "", {std::istreambuf_iterator<char>(demo), {}}},
                         {0, 0, "../../../climbing.toml", "", "x = 1"}};
  record::Recorder(mcap::file_sink(path, true).value(), options).finish();
  auto recording = record::Recording::open(path).value();
  fs::remove(path);
  const RecordedRig rig(recording);
  EXPECT_EQ(rig.rig().devices.size(), 6u);
  EXPECT_TRUE(rig.rig().estimators.empty());
  EXPECT_NE(rig.trouble().find("s-path.toml"), std::string::npos) << rig.trouble();
  std::size_t inside = 0;
  for (const auto& entry : fs::recursive_directory_iterator(rig.folder()))
    inside += entry.path().filename() == "climbing.toml" ? 1U : 0U;
  EXPECT_EQ(inside, 1u) << "what climbs out of its folder stays in ours";
}

}  // namespace recorded_rig_test
