#include <gmock/gmock.h>

#include <fstream>

#include "rig_config/kinematic_vehicle.hpp"
#include "rig_config/load.hpp"
#include "rig_config/steering.hpp"
#include "tests/rig_config/problems.hpp"

namespace drydock::rig_config {
namespace thruster_vehicle_test {

using test::lines_of;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string missions = DRYDOCK_SOURCE_DIR "/rig_config/missions/";

Loaded<MissionConfig> mission_with(const std::string& keys) {
  return load_mission_text("[mission]\nlatitude_deg = 1\nlongitude_deg = 2\n" + keys,
                           missions + "m.toml");
}

TEST(ThrusterVehicle, TheShippedOneHasTheFiguresOfItsSource) {
  const auto mission = load_mission(missions + "ardusub.toml");
  ASSERT_TRUE(mission);
  EXPECT_EQ(mission->steering->from, "ardupilot");
  EXPECT_EQ(mission->steering->listen, "127.0.0.1:9002");
  EXPECT_FALSE(mission->vehicle);
  const auto& vehicle = mission->thruster_vehicle.value();
  EXPECT_EQ(vehicle.mass_kg, 11.5);
  EXPECT_EQ(vehicle.buoyancy_n, 114.8);
  EXPECT_THAT(vehicle.added_mass, ElementsAre(5.5, 12.7, 14.57, 0.12, 0.12, 0.12));
  EXPECT_EQ(vehicle.quadratic_damping[2], 36.99);
  ASSERT_EQ(vehicle.thrusters.size(), 6u);
  EXPECT_EQ(vehicle.thrusters[4].name, "vertical-starboard");
  EXPECT_THAT(vehicle.thrusters[4].direction, ElementsAre(0, 0, 1));
  EXPECT_EQ(vehicle.thrusters[0].astern_n, 40.2);
}

TEST(ThrusterVehicle, CannotSailLegs) {
  const auto mission = mission_with(
      "speed_mps = 1\nvehicle = \"../vehicles/bluerov2.toml\"\n[[leg]]\nkind = \"straight\"\n"
      "duration_s = 5\n");
  ASSERT_FALSE(mission);
  EXPECT_THAT(lines_of(mission.error()),
              ElementsAre(HasSubstr(":5:11: /mission/vehicle: a vehicle with thrusters cannot sail "
                                    "legs by itself: allowed with [steering]")));
}

TEST(ThrusterVehicle, IsNotOneWithFins) {
  const auto vehicle = load_vehicle(DRYDOCK_SOURCE_DIR "/rig_config/vehicles/bluerov2.toml");
  ASSERT_FALSE(vehicle);
  EXPECT_THAT(lines_of(vehicle.error()),
              ElementsAre(HasSubstr("/thruster: this vehicle has thrusters")));
  EXPECT_THAT(check_file(DRYDOCK_SOURCE_DIR "/rig_config/vehicles/bluerov2.toml"),
              testing::IsEmpty());
}

TEST(ThrusterVehicle, EachThrusterHasANameOfItsOwnForItsOrders) {
  std::ifstream file(DRYDOCK_SOURCE_DIR "/rig_config/vehicles/bluerov2.toml");
  std::string text(std::istreambuf_iterator<char>(file), {});
  const auto twin = text.find("front-port");
  ASSERT_NE(twin, text.npos);
  text.replace(twin, std::string("front-port").size(), "front-starboard");
  EXPECT_THAT(lines_of(load_vehicle_text(text, "v.toml").error()),
              testing::Contains(HasSubstr("/thruster/1/name: \"front-starboard\" is used twice")));
}

TEST(Steering, HasNoLegsAndIsOfAKinematicVehicleWhereTheMissionNamesNone) {
  for (const char* from : {"ardupilot", "dds"}) {
    const auto kinematic = mission_with("[steering]\nfrom = \"" + std::string(from) + "\"\n");
    ASSERT_TRUE(kinematic) << lines_of(kinematic.error()).front();
    EXPECT_TRUE(is_kinematic(kinematic->vehicle.value()));
  }
  const auto with_legs = mission_with(
      "vehicle = \"../vehicles/nps-auv-ii.toml\"\n[steering]\nfrom = \"ardupilot\"\n[[leg]]\nkind "
      "= "
      "\"straight\"\nduration_s = 5\n");
  ASSERT_FALSE(with_legs);
  EXPECT_THAT(lines_of(with_legs.error()),
              testing::Contains(HasSubstr("another program steers the vehicle")));
}

TEST(Steering, OverDdsHasNeitherLegsNorAPort) {
  const std::string dds = "[steering]\nfrom = \"dds\"\n";
  const auto rov = mission_with("vehicle = \"../vehicles/bluerov2.toml\"\n" + dds);
  ASSERT_TRUE(rov);
  EXPECT_TRUE(steered_over_dds(*rov));
  EXPECT_FALSE(steered_over_wires(*rov));
  EXPECT_TRUE(mission_with("vehicle = \"../vehicles/nps-auv-ii.toml\"\n" + dds));
  EXPECT_THAT(lines_of(mission_with(dds + "listen = \"127.0.0.1:1\"\n").error()),
              ElementsAre(HasSubstr("only for from = \"ardupilot\"")));
  EXPECT_THAT(lines_of(mission_with("vehicle = \"../vehicles/nps-auv-ii.toml\"\n" + dds +
                                    "[[leg]]\nkind = \"straight\"\nduration_s = 5\n")
                           .error()),
              testing::Contains(HasSubstr("another program steers the vehicle")));
}

TEST(Steering, ByAProgramHasItsCommandAndRunsInTheFolderOfTheMission) {
  const std::string program = "[steering]\nfrom = \"program\"\n";
  const auto mission = mission_with(program + "command = [\"./pilot\", \"-v\"]\ntruth = true\n");
  ASSERT_TRUE(mission) << lines_of(mission.error()).front();
  EXPECT_TRUE(steered_by_program(*mission));
  EXPECT_THAT(mission->steering->command, ElementsAre("./pilot", "-v"));
  EXPECT_THAT(mission->steering->folder, testing::EndsWith("rig_config/missions"));
  EXPECT_TRUE(mission->steering->truth);
  EXPECT_EQ(mission->steering->step_s, 0.05);
  EXPECT_THAT(lines_of(mission_with(program).error()),
              ElementsAre(HasSubstr("/steering: key 'command' is missing")));
  EXPECT_THAT(lines_of(mission_with(program + "command = [\"a\"]\nstep_s = 0.6\n").error()),
              ElementsAre(HasSubstr("/steering/step_s")));
  EXPECT_THAT(lines_of(mission_with("[steering]\nfrom = \"dds\"\ncommand = [\"a\"]\n").error()),
              ElementsAre(HasSubstr("only for from = \"program\"")));
}

TEST(Steering, OverTheWiresMayHaveLegsAndNeedNotHaveAVehicle) {
  const std::string wires = "[steering]\nfrom = \"wires\"\n";
  const auto kinematic =
      mission_with("speed_mps = 2\n" + wires + "[[leg]]\nkind = \"straight\"\nduration_s = 5\n");
  ASSERT_TRUE(kinematic);
  EXPECT_TRUE(steered_over_wires(*kinematic));
  EXPECT_TRUE(is_kinematic(kinematic->vehicle.value()));
  EXPECT_THAT(lines_of(mission_with(wires).error()),
              ElementsAre(HasSubstr("/mission: key 'speed_mps' is missing")));
  EXPECT_THAT(
      lines_of(mission_with("speed_mps = 2\n" + wires + "listen = \"127.0.0.1:1\"\n").error()),
      ElementsAre(HasSubstr("only for from = \"ardupilot\"")));
}

TEST(Steering, OverTheWiresAVehicleWithThrustersBeginsAtRestAndHasNoLegs) {
  const std::string rov = "vehicle = \"../vehicles/bluerov2.toml\"\n",
                    wires = "[steering]\nfrom = \"wires\"\n";
  const auto waits = mission_with(rov + wires);
  ASSERT_TRUE(waits) << lines_of(waits.error()).front();
  EXPECT_NEAR(waits->thruster_vehicle->thrusters[0].limit_radps, 120 * M_PI, 1e-9);
  EXPECT_THAT(lines_of(mission_with("speed_mps = 1\n" + rov + wires).error()),
              ElementsAre(HasSubstr(":4:13: /mission/speed_mps: a vehicle with thrusters begins")));
  EXPECT_THAT(lines_of(mission_with("speed_mps = 0\n" + rov + wires +
                                    "[[leg]]\nkind = \"straight\"\nduration_s = 5\n")
                           .error()),
              ElementsAre(HasSubstr("cannot sail legs by itself")));
}

Loaded<Rig> rig_with(const std::string& mission, const std::string& device) {
  return load_rig_text("[rig]\nname = \"r\"\nmission = \"../missions/" + mission +
                           "\"\n[[device]]\nname = \"a\"\nkind = \"actuator\"\nlink = "
                           "\"memory-can:b\"\naddress = 9\nrate_hz = 10\n" +
                           device,
                       DRYDOCK_SOURCE_DIR "/rig_config/rigs/r.toml");
}

TEST(Steering, ADriveMovesWhatTheVehicleHas) {
  const auto drive = [](int instance) {
    return "protocol = \"cia402\"\ninstance = " + std::to_string(instance) + "\n";
  };
  EXPECT_TRUE(rig_with("thrusters.toml", drive(4)));
  EXPECT_TRUE(rig_with("thrusters.toml", drive(9)));
  for (const int other : {0, 3, 10})
    EXPECT_THAT(lines_of(rig_with("thrusters.toml", drive(other)).error()),
                ElementsAre(HasSubstr(
                    ":11:12: /device/0/instance: vehicle bluerov2 has thrusters alone, allowed: 4 "
                    "to 9")));
  EXPECT_TRUE(rig_with("loop.toml", drive(3)));
  EXPECT_THAT(lines_of(rig_with("loop.toml", drive(4)).error()),
              ElementsAre(HasSubstr("the vehicle of the mission has no thrusters")));
  EXPECT_THAT(
      lines_of(rig_with("thrusters.toml", "protocol = \"nmea2000\"\n").error()),
      ElementsAre(HasSubstr("/device/0/protocol: on NMEA 2000 nothing moves the thrusters")));
}

}  // namespace thruster_vehicle_test
}  // namespace drydock::rig_config
