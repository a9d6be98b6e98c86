#include <gtest/gtest.h>

#include "tests/hil/emulate/water_linked_json.hpp"

/// What the emulated DVL answers to its clients, and how it obeys them.
namespace drydock::emulate {
namespace water_linked_json_commands_test {

TEST_F(WaterLinkedJsonDvl, AnswersHaveTheNameTheFormatAndTheType) {
  const json m = answer_to("{\"command\":\"get_config\"}\r\n");
  EXPECT_EQ(m, json::parse(R"({"response_to":"get_config","success":true,"error_message":"",
      "result":{"speed_of_sound":1475,"acoustic_enabled":true,"dark_mode_enabled":false,
      "mounting_rotation_offset":0,"range_mode":"auto","periodic_cycling_enabled":true},
      "format":"json_v3.3","type":"response"})"));
  EXPECT_EQ(result_of("get_version_info")["product_id"], 21035);
  EXPECT_EQ(result_of("get_version_info")["product_name"], "DVL A50");
  EXPECT_EQ(result_of("get_time_status")["system_time"], "2023-11-14T22:13:20.000Z");
  EXPECT_EQ(result_of("force_sync_ntp")["success"], true);
  EXPECT_EQ(answer_to(R"({"command":"set_time_manual"})")["error_message"],
            "Manual time not allowed when NTP is synchronized");
}

TEST_F(WaterLinkedJsonDvl, OnlyTheClientThatAskedHearsTheAnswer) {
  run_to(0.05);
  room_.asks = 3;
  say(R"({"command":"get_config"})");
  EXPECT_EQ(room_.said.back().to, 3U);
  EXPECT_EQ(room_.said.front().to, every_client) << "a report";
}

TEST_F(WaterLinkedJsonDvl, WhatComesInOneReadIsOneDocument) {
  EXPECT_EQ(answer_to(R"({"command":"get_config"})")["success"], true) << "without a line end";
  EXPECT_EQ(answer_to("{\n  \"command\": \"get_config\"\n}\n")["success"], true);
  for (const char* bad : {"{\"command\":\"get_config\"}\r\n{\"command\":\"get_config\"}\r\n",
                          "hello", "{\"command\":", ""}) {
    const json m = answer_to(bad);
    EXPECT_EQ(m["success"], false) << bad;
    EXPECT_EQ(m["error_message"], "Invalid JSON");
    EXPECT_EQ(m["response_to"], "");
    EXPECT_EQ(m["result"], nullptr);
  }
  EXPECT_EQ(answer_to(std::string(5000, ' '))["error_message"], "Invalid JSON");
}

TEST_F(WaterLinkedJsonDvl, AnUnknownCommandIsNotRecognised) {
  const json m = answer_to(R"({"command":"dance"})");
  EXPECT_EQ(m["response_to"], "dance");
  EXPECT_EQ(m["success"], false);
  EXPECT_EQ(m["error_message"], "Command not recognised");
}

TEST_F(WaterLinkedJsonDvl, TurnsItsVelocityByTheMountingRotation) {
  EXPECT_EQ(set(R"({"mounting_rotation_offset":90.0})")["success"], true);
  const json m = report();
  // The DVL points to starboard: its forward is the vehicle's starboard, its starboard is astern.
  EXPECT_NEAR(m["vx"], -0.123, 1e-8);
  EXPECT_NEAR(m["vy"], 2.0, 1e-8);
  EXPECT_EQ(result_of("get_config")["mounting_rotation_offset"], 90);
}

TEST_F(WaterLinkedJsonDvl, AWrongSpeedOfSoundMakesVelocityAndAltitudeWrong) {
  const double right = trajectory_.ocean().sound_speed_mps(20);
  EXPECT_EQ(set("{\"speed_of_sound\":" + std::to_string(1.01 * right) + "}")["success"], true);
  const json m = report();
  EXPECT_NEAR(m["vx"], 2.02, 1e-5);
  EXPECT_NEAR(m["altitude"], 30.3, 0.006);
}

TEST_F(WaterLinkedJsonDvl, RefusesWhatItCannotDoAndKeepsItsSettings) {
  const json before = result_of("get_config");
  for (const char* bad :
       {R"({"speed_of_sound":999})", R"({"speed_of_sound":2001})", R"({"range_mode":"=5"})",
        R"({"mounting_rotation_offset":361})", R"({"mounting_rotation_offset":-1})",
        R"({"range_mode":"3<=1"})", R"({"speed_of_sound":"fast"})",
        R"({"mountig_rotation_offset":1})", "{}", "[]", "null"}) {
    const json m = set(bad);
    EXPECT_EQ(m["success"], false) << bad;
    EXPECT_NE(m["error_message"], "") << bad;
  }
  EXPECT_EQ(result_of("get_config"), before);
}

TEST_F(WaterLinkedJsonDvl, PingsAsOftenAsItsRangeMode) {
  config_.emulate.latency_s = 0;
  make(trajectory_);
  sent_until(0.95, "velocity");
  EXPECT_EQ(set(R"({"range_mode":"=3"})")["success"], true);
  EXPECT_EQ(sent_until(10.95, "velocity").size(), 75U) << "7.5 Hz";
  EXPECT_EQ(set(R"({"range_mode":"=4"})")["success"], true);
  EXPECT_EQ(sent_until(20.95, "velocity").size(), 30U) << "3 Hz";
  EXPECT_EQ(set(R"({"range_mode":"2<=4"})")["success"], true);
  EXPECT_EQ(sent_until(30.95, "velocity").size(), 50U) << "of the rig file";
}

TEST_F(WaterLinkedJsonDvl, ARangeModeSeesOnlyItsOwnAltitudes) {
  // The bed is 30 m below: too far for mode 2 (14 m), within modes 3 (36 m) and 4.
  EXPECT_EQ(set(R"({"range_mode":"=2"})")["success"], true);
  EXPECT_EQ(report(0.3)["velocity_valid"], false);
  EXPECT_EQ(set(R"({"range_mode":"2<=3"})")["success"], true);
  EXPECT_EQ(report(0.6)["velocity_valid"], true);
}

TEST_F(WaterLinkedJsonDvl, WaterTrackTellsTheVelocityThroughTheWater) {
  motion::Truth truth = under_way();
  rig_config::OceanConfig ocean;
  const Frozen still(truth, ocean);
  make(still);
  EXPECT_EQ(set(R"({"range_mode":"wt"})")["success"], true);
  EXPECT_TRUE(sent_until(0.05, "velocity").empty());
  const auto reports = sent_until(10.05, "velocity_water");
  EXPECT_EQ(reports.size(), 20U) << "2 Hz";
  EXPECT_EQ(reports.at(0)["velocity_valid"], true);
  EXPECT_NEAR(reports.at(0)["vx"], 2.0, 1e-6) << "the water stands still";
  EXPECT_FALSE(reports.at(0).contains("altitude"));
}

TEST_F(WaterLinkedJsonDvl, WithAcousticsOffItPingsWhenToldTo) {
  EXPECT_EQ(answer_to(R"({"command":"trigger_ping"})")["success"], false) << "acoustics are on";
  EXPECT_EQ(set(R"({"acoustic_enabled":false})")["success"], true);
  EXPECT_TRUE(sent_until(1, "velocity").empty());
  for (int i = 0; i < 15; ++i)
    EXPECT_EQ(answer_to(R"({"command":"trigger_ping"})")["success"], true) << i;
  EXPECT_EQ(answer_to(R"({"command":"trigger_ping"})")["success"], false) << "the queue is full";
  EXPECT_EQ(sent_until(20, "velocity").size(), 15U);
}

TEST_F(WaterLinkedJsonDvl, TheGyroIsCalibratedAfterAWhile) {
  room_.asks = 5;
  EXPECT_TRUE(answer_to(R"({"command":"calibrate_gyro"})").is_null());
  EXPECT_TRUE(sent_until(14.9, "response").empty());
  room_.asks = 6;
  const auto answers = sent_until(15.1, "response");
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0]["response_to"], "calibrate_gyro");
  EXPECT_EQ(answers[0]["success"], true);
  EXPECT_EQ(std::ranges::count(room_.said, Client{5}, &Room::Said::to), 1);
}

}  // namespace water_linked_json_commands_test
}  // namespace drydock::emulate
