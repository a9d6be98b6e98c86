// Commands that need no link: studies, the sky, sensor grades, manoeuvres.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/hil/program/program.hpp"

namespace program_models_test {

using program::drydock;
using program::Folder;
using program::read_file;
using testing::HasSubstr;

TEST(Program, AStudyGivesTheSameFilesOnOneThreadAndOnThree) {
  const Folder folder;
  const auto study = [&](const std::string& jobs) {
    const auto json = folder / (jobs + ".json");
    const auto outcome = drydock("study leveling --runs 4 --jobs " + jobs + " --json " +
                                 json.string() + " --report " + (folder / jobs).string());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("leveling: 4 of 4 runs, seed 1"));
    return read_file(json) + read_file(folder / jobs / "index.html");
  };
  const auto alone = study("1");
  EXPECT_THAT(alone, HasSubstr("\"augmented\""));
  EXPECT_EQ(study("3"), alone);
}

TEST(Program, AStudyWithWrongArgumentsSaysWhatIsAllowed) {
  const auto name = drydock("study levelling");
  EXPECT_EQ(name.exit_code, 2);
  EXPECT_EQ(name.output.find(
                "study: 'levelling' is not known (did you mean 'leveling'?), allowed: leveling"),
            0U);
  const auto runs = drydock("study leveling --runs 0");
  EXPECT_EQ(runs.exit_code, 2);
  EXPECT_THAT(runs.output, HasSubstr("1 to 1000000"));
}

TEST(Program, TheSkyIsATableJsonAndAPlot) {
  const Folder folder;
  const std::string ask = "sky --ephemeris fixtures/rinex/walker.rnx --at 2026-11-21T09:59:42Z ";
  const auto table = drydock(ask);
  EXPECT_EQ(table.exit_code, 0) << table.output;
  EXPECT_THAT(table.output, HasSubstr("2026-11-21T10:00:00 GPS  (week 2445, 554400.000 s"));
  EXPECT_THAT(table.output, HasSubstr("G25  bad 63"));
  EXPECT_THAT(table.output, HasSubstr("refused: G26 of line 204"));
  EXPECT_THAT(table.output, testing::Not(HasSubstr("elevation")));

  const auto plot = (folder / "sky.svg").string();
  const auto json = drydock(ask + "--from 0,0,0 --json --plot " + plot);
  ASSERT_EQ(json.exit_code, 0) << json.output;
  const auto sky = nlohmann::json::parse(json.output);
  ASSERT_EQ(sky["satellites"].size(), 25u);
  // Satellite 1 is over the Gulf of Guinea at toe: (a, 0, 0).
  EXPECT_EQ(sky["satellites"][0]["prn"], 1);
  EXPECT_NEAR(sky["satellites"][0]["elevation_deg"], 90, 0.01);
  EXPECT_NEAR(sky["satellites"][0]["ecef_m"][0], 26'559'710, 1e-3);
  EXPECT_NEAR(sky["satellites"][0]["clock_s"], 1e-6, 1e-15);
  EXPECT_EQ(sky["refused"][0]["prn"], 26);
  EXPECT_THAT(read_file(plot), testing::StartsWith("<svg"));
}

TEST(Program, AGradesAllanDeviationIsATableJsonAndAPlot) {
  const Folder folder;
  const std::string ask = "sensor rig_config/sensors/xsens-mti-630.toml --for 1h ";
  const auto table = drydock(ask);
  EXPECT_EQ(table.exit_code, 0) << table.output;
  EXPECT_THAT(table.output, HasSubstr("gyro [deg/h]"));

  const auto plot = (folder / "allan.svg").string();
  const auto json = drydock(ask + "--json --allan " + plot);
  ASSERT_EQ(json.exit_code, 0) << json.output;
  for (const auto& row : nlohmann::json::parse(json.output)) {
    if (row["tau_s"] > 3) break;
    // 0.007 deg/s/sqrt(Hz) and 60 ug/sqrt(Hz) are 25.2 deg/h and 60 ug at 1 s.
    const double root = std::sqrt(row["tau_s"].get<double>());
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(row["gyro_degph"][axis].get<double>() * root, 25.2, 0.1 * 25.2);
      EXPECT_NEAR(row["accelerometer_ug"][axis].get<double>() * root, 60, 0.1 * 60);
    }
  }
  EXPECT_THAT(read_file(plot), testing::StartsWith("<svg"));
  EXPECT_EQ(drydock("sensor rig_config/sensors/water-linked-a50.toml").exit_code, 2);
}

TEST(Program, ASkyThatCannotBeToldExitsWithOneAndAWrongQuestionWithTwo) {
  const std::string file = "sky --ephemeris fixtures/rinex/walker.rnx ";
  const auto late = drydock(file + "--at 2026-11-21T13:00:00Z");
  EXPECT_EQ(late.exit_code, 1);
  EXPECT_THAT(late.output, HasSubstr("has no record within 2 h of 2026-11-21T13:00:18 GPS"));
  EXPECT_EQ(drydock("sky --ephemeris README.md --at 2026-11-21T13:00:00Z").exit_code, 1);
  EXPECT_EQ(drydock(file + "--at noon").exit_code, 2);
  EXPECT_EQ(drydock(file + "--at 2026-11-21T10:00:00Z --from 91,0").exit_code, 2);
  EXPECT_EQ(drydock(file + "--at 2026-11-21T10:00:00Z --plot sky.svg").exit_code, 2);
}

TEST(Program, AManeuverIsATableJsonATrackAndAPlot) {
  const Folder folder;
  const std::string ask = "maneuver rig_config/vehicles/nps-auv-ii.toml turning-circle ";
  EXPECT_THAT(drydock(ask).output, HasSubstr("tactical diameter"));

  const auto plot = (folder / "c.svg").string(), track = (folder / "c.csv").string();
  const auto json = drydock(ask + "--deflection 10 --json --plot " + plot + " --csv " + track);
  ASSERT_EQ(json.exit_code, 0) << json.output;
  const auto figures = nlohmann::json::parse(json.output);
  EXPECT_NEAR(figures["steady_turning_diameter_m"], 2 * 29.46, 0.6);
  EXPECT_NEAR(figures["steady_rate_of_turn_degps"], -3.189, 0.13);
  EXPECT_THAT(read_file(plot), testing::StartsWith("<svg"));
  EXPECT_THAT(read_file(track),
              testing::StartsWith("t,u,v,w,p,q,r,x,y,z,phi,theta,psi,delta_r,delta_s,delta_b\n"
                                  "0,1.884955592,0,0,"));
}

TEST(Program, AManeuverWithoutVehicleScheduleOrPlaceToWriteSaysSo) {
  const std::string file = "maneuver rig_config/vehicles/nps-auv-ii.toml ";
  EXPECT_EQ(drydock(file).exit_code, 2);
  EXPECT_EQ(drydock("maneuver rig_config/rigs/demo.toml zigzag").exit_code, 2);
  const auto schedule = drydock(file + "--schedule README.md");
  EXPECT_EQ(schedule.exit_code, 2);
  EXPECT_THAT(schedule.output, HasSubstr("README.md:1: the header must be t,rudder"));
  const auto unwritable = drydock(file + "dive --csv /dev/null/track.csv");
  EXPECT_EQ(unwritable.exit_code, 1);
  EXPECT_THAT(unwritable.output, HasSubstr("cannot write /dev/null/track.csv: Not a directory"));
}

}  // namespace program_models_test
