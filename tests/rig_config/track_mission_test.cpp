#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "tests/rig_config/problems.hpp"

namespace drydock::rig_config::test {
namespace track_mission_test {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* place = "[mission]\nlatitude_deg = 36\nlongitude_deg = 129\n";

TEST(TrackMission, NamesItsFileBesideTheMissionAndHasNoLegs) {
  const auto folder = std::filesystem::temp_directory_path() / "track-mission-test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "way.csv") << "time_s\n";
  const auto path = (folder / "mission.toml").string();
  const auto mission =
      load_mission_text(std::string(place) + "[track]\nfile = \"way.csv\"\n", path);
  ASSERT_TRUE(mission) << lines_of(mission.error()).front();
  EXPECT_EQ(mission->track->file, (folder / "way.csv").string());
  EXPECT_THAT(mission->files, ElementsAre((folder / "way.csv").string()));
  EXPECT_TRUE(mission->legs.empty());
  std::filesystem::remove_all(folder);
}

TEST(TrackMission, RefusesLegsASpeedAndAFileThatIsNotThere) {
  const auto mission = load_mission_text(
      std::string(place) +
          "speed_mps = 1\n[track]\nfile = \"nowhere.csv\"\n[[leg]]\nkind = \"straight\"\n"
          "duration_s = 5\n",
      "m.toml");
  ASSERT_FALSE(mission);
  const auto lines = lines_of(mission.error());
  EXPECT_THAT(lines, Contains(HasSubstr("/mission/speed_mps: not allowed here, not with [track]")));
  EXPECT_THAT(lines, Contains(HasSubstr("/leg: not allowed here, not with [track]")));
  const auto missing =
      load_mission_text(std::string(place) + "[track]\nfile = \"nowhere.csv\"\n", "m.toml");
  ASSERT_FALSE(missing);
  EXPECT_THAT(lines_of(missing.error()),
              Contains(HasSubstr("/track/file: there is no file nowhere.csv")));
}

}  // namespace track_mission_test
}  // namespace drydock::rig_config::test
