#include "tests/rig_config/problems.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>

/// Missions, and files that name other files.
namespace drydock::rig_config::test {
namespace files_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(MissionProblems, ALegHasTheKeysOfItsKindOnly) {
  const auto mission = load_mission_text(
      "[mission]\nlatitude_deg = 89.95\nlongitude_deg = 0\nspeed_mps = 1\n"
      "[[leg]]\nkind = \"turn\"\nduration_s = 5\nperiod_s = 3\n",
      "m.toml");
  ASSERT_FALSE(mission);
  EXPECT_THAT(
      lines_of(mission.error()),
      ElementsAre(
          "m.toml:2:16: /mission/latitude_deg: 89.95 is out of range, allowed: -89.9 to 89.9",
          "m.toml:5:1: /leg/0: key 'turn_deg' is missing",
          "m.toml:8:1: /leg/0/period_s: not allowed here, only for kind = "
          "\"s_path\" or \"zigzag\""));
}

TEST(MissionProblems, AMissionStaysInTheWater) {
  const auto mission = load_mission_text(
      "ocean.bed = { kind = \"plane\", depth_m = 20 }\n"
      "[mission]\nlatitude_deg = 0\nlongitude_deg = 0\nspeed_mps = 1\n"
      "[[leg]]\nkind = \"dive\"\nduration_s = 60\ndepth_change_m = 21\n"
      "[[leg]]\nkind = \"dive\"\nduration_s = 60\ndepth_change_m = -30\n",
      "m.toml");
  ASSERT_FALSE(mission);
  EXPECT_THAT(lines_of(mission.error()),
              ElementsAre("m.toml:9:18: /leg/0/depth_change_m: the leg ends at a depth of 21 m, "
                          "allowed: 0 (the surface) to 20 (the bed)",
                          "m.toml:13:18: /leg/1/depth_change_m: the leg ends at a depth of -9 m, "
                          "allowed: 0 (the surface) to 20 (the bed)"));
}

TEST(MissionProblems, AnOceanHasTheKeysOfItsKindsAndDepthsThatRise) {
  const auto mission = load_mission_text(
      "[mission]\nlatitude_deg = 0\nlongitude_deg = 0\nspeed_mps = 1\n"
      "[[leg]]\nkind = \"straight\"\nduration_s = 5\n"
      "[ocean]\nbed = { kind = \"raster\", file = \"none.asc\", gradient = 0.1 }\n"
      "[[ocean.current]]\ndepth_m = 5\nvelocity_ned_mps = [0.1, 0, 0]\n"
      "[[ocean.current]]\ndepth_m = 5\nvelocity_ned_mps = [0.2, 0, 0]\n"
      "[ocean.water]\nkind = \"standard\"\ndensity_kgm3 = 1025\n",
      "m.toml");
  ASSERT_FALSE(mission);
  EXPECT_THAT(
      lines_of(mission.error()),
      ElementsAre("m.toml:9:33: /ocean/bed/file: there is no file none.asc",
                  "m.toml:9:45: /ocean/bed/gradient: not allowed here, only for kind = \"slope\"",
                  "m.toml:14:11: /ocean/current/1/depth_m: 5 is not below the one before, "
                  "allowed: more than 5",
                  "m.toml:18:1: /ocean/water/density_kgm3: not allowed here, only with kind = "
                  "\"uniform\""));
}

TEST(MissionProblems, ABallisticFlightHasNoLegsAndItsOwnSpeed) {
  const auto mission = load_mission_text(
      "[mission]\nlatitude_deg = 0\nlongitude_deg = 0\nspeed_mps = 1\n"
      "[ballistic]\nspeed_mps = 700\nelevation_deg = 89\n"
      "[[leg]]\nkind = \"straight\"\nduration_s = 5\n",
      "m.toml");
  ASSERT_FALSE(mission);
  const auto lines = lines_of(mission.error());
  EXPECT_THAT(lines,
              testing::Contains(HasSubstr(
                  "/mission/speed_mps: not allowed here, a ballistic flight has its speed")));
  EXPECT_THAT(lines, testing::Contains(
                         "m.toml:7:17: /ballistic/elevation_deg: 89 is out of range, allowed: -85 "
                         "to 85"));
  EXPECT_THAT(lines, testing::Contains(HasSubstr("/leg: not allowed here, a ballistic flight")));
}

TEST(Mission, TheSoundingRocketsFlightIsInSiAndRadians) {
  const auto mission =
      load_mission(DRYDOCK_SOURCE_DIR "/rig_config/missions/sounding-rocket.toml").value();
  ASSERT_TRUE(mission.ballistic);
  EXPECT_EQ(mission.speed_mps, 700);
  EXPECT_DOUBLE_EQ(mission.ballistic->elevation_rad, std::numbers::pi / 4);
  EXPECT_DOUBLE_EQ(mission.ballistic->roll_rate_radps, std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(mission.ballistic->coning_radps, 2 * std::numbers::pi);
  EXPECT_EQ(mission.ballistic->ballistic_coefficient_kgm2, 20000);
  EXPECT_TRUE(mission.legs.empty());
}

TEST(Mission, ItsVehicleIsReadFromTheFileBesideIt) {
  const auto mission =
      load_mission(DRYDOCK_SOURCE_DIR "/rig_config/missions/velocity-paper.toml").value();
  ASSERT_TRUE(mission.vehicle);
  EXPECT_EQ(mission.vehicle->name, "nps-auv-ii");
  EXPECT_EQ(mission.legs.at(2).kind, LegKind::spiral);
  EXPECT_DOUBLE_EQ(mission.legs.at(2).rate_radps, std::numbers::pi / 120);
  EXPECT_DOUBLE_EQ(mission.legs.at(2).end_rate_radps, std::numbers::pi / 360);
  EXPECT_EQ(mission.legs.at(2).ramp_s, 72);
  EXPECT_EQ(mission.legs.at(5).kind, LegKind::zigzag);
  EXPECT_EQ(mission.legs.at(7).kind, LegKind::surface);
}

TEST(MissionProblems, AVehiclesFileIsThereAndItsLegsAreForAVehicle) {
  const std::string head = "[mission]\nlatitude_deg = 0\nlongitude_deg = 0\nspeed_mps = 1\n";
  const auto sailed = load_mission_text(
      head +
          "vehicle = \"none.toml\"\n"
          "[[leg]]\nkind = \"turn\"\nduration_s = 60\nturn_deg = 9\nroll_deg = 3\n",
      "m.toml");
  EXPECT_THAT(lines_of(sailed.error()),
              ElementsAre("m.toml:5:11: /mission/vehicle: there is no file none.toml",
                          "m.toml:10:12: /leg/0/roll_deg: not allowed here, a vehicle heels as its "
                          "equations of motion say"));
  const auto kinematic = load_mission_text(
      head + "[[leg]]\nkind = \"turning_circle\"\nduration_s = 60\nrudder_deg = 9\n", "m.toml");
  EXPECT_THAT(lines_of(kinematic.error()),
              ElementsAre("m.toml:6:8: /leg/0/kind: a turning_circle is steered by a rudder: give "
                          "the mission a vehicle, or take a turn"));
}

TEST(MissionProblems, AFaultOfTheVehicleFileIsOneOfTheMission) {
  const auto mission = load_mission_text(
      "[mission]\nlatitude_deg = 0\nlongitude_deg = 0\nspeed_mps = 1\n"
      "vehicle = \"rigs/demo.toml\"\n[[leg]]\nkind = \"straight\"\nduration_s = 5\n",
      DRYDOCK_SOURCE_DIR "/rig_config/m.toml");
  EXPECT_THAT(lines_of(mission.error()),
              ElementsAre(HasSubstr("rigs/demo.toml:1:1: /: expected a vehicle file")));
}

TEST(Sky, AReceiversEphemerisIsSoughtFromTheRigFile) {
  const auto rig = load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/sounding-rocket.toml").value();
  const auto& sky = rig.devices.at(0).emulate.sky;
  ASSERT_TRUE(sky);
  EXPECT_EQ(sky->ephemeris, DRYDOCK_SOURCE_DIR "/fixtures/rinex/walker.rnx");
  EXPECT_EQ(sky->antenna_axis, (std::array<double, 3>{0, 0, 1}));
  EXPECT_EQ(sky->power_noise, 0.1);
  EXPECT_EQ(sky->at_utc_ns, rig.start_utc_ns);
  EXPECT_FALSE(rig.devices.at(1).emulate.sky);
}

TEST(Sky, AMissingEphemerisIsToldWithItsPlace) {
  const auto rig = load_rig_text(
      "[rig]\nname = \"r\"\n[[device]]\nname = \"g\"\nkind = \"gnss\"\nprotocol = \"ubx\"\n"
      "link = \"pty:g\"\n[device.emulate.sky]\nephemeris = \"none.rnx\"\nantenna_axis = \"up\"\n",
      "/nowhere/r.toml");
  ASSERT_FALSE(rig);
  EXPECT_THAT(lines_of(rig.error()),
              ElementsAre(HasSubstr("9:13: /device/0/emulate/sky/ephemeris: there is no file "
                                    "/nowhere/none.rnx"),
                          HasSubstr("/device/0/emulate/sky/antenna_axis: \"up\" is not allowed")));
}

/// A folder of files that is removed after the test.
class Folder {
 public:
  Folder() : path_(testing::TempDir() + "rig_config_problems_" + name()) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string write(const std::string& name, std::string_view text) const {
    std::ofstream(path_ / name) << text;
    return (path_ / name).string();
  }

 private:
  /// Tests run side by side, each in a process.
  static std::string name() {
    return testing::UnitTest::GetInstance()->current_test_info()->name();
  }

  std::filesystem::path path_;
};

TEST(CheckFile, TellsTheKindsApart) {
  const Folder folder;
  const auto mission = folder.write("m.toml", "[mission]\nlatitude_deg = 1\n");
  const auto sensor = folder.write("s.toml", "[imu]\ngyro_bias = 1\n");
  const auto vehicle = folder.write("v.toml", "[vehicle]\nname = \"v\"\n");
  EXPECT_THAT(lines_of(check_file(mission)), testing::Contains(HasSubstr(":1:1: /: key 'leg' is")));
  EXPECT_THAT(
      lines_of(check_file(sensor)),
      ElementsAre(HasSubstr(
          ":2:1: /imu/gyro_bias: unknown key (did you mean 'gyro_bias_degph'?), allowed here: "
          "accelerometer_anisoelasticity_ugpg2")));
  EXPECT_THAT(lines_of(check_file(vehicle)),
              testing::Contains(HasSubstr(":1:1: /: key 'rudder' is missing")));
}

TEST(CheckFile, APartOfARigIsReportedUnderItsOwnName) {
  const Folder folder;
  const auto mission = folder.write("m.toml", "[mission]\nspeed_mps = -1\n");
  const auto grade = folder.write("imu.toml", "[imu]\ngyro_bias_degph = 1\n");
  const auto rig =
      folder.write("r.toml", "[rig]\nname = \"r\"\nmission = \"m.toml\"\n" +
                                 std::string(dvl_table) + "emulate = { errors = \"imu.toml\" }\n");
  EXPECT_THAT(
      lines_of(check_file(rig)),
      ElementsAre(mission + ":1:1: /: key 'leg' is missing",
                  mission + ":1:1: /mission: key 'latitude_deg' is missing",
                  mission + ":1:1: /mission: key 'longitude_deg' is missing",
                  mission + ":2:13: /mission/speed_mps: -1 is out of range, allowed: 0 to 30",
                  rig + ":9:22: /device/0/emulate/errors: " + grade + " has no table [dvl]"));
}

}  // namespace files_test
}  // namespace drydock::rig_config::test
