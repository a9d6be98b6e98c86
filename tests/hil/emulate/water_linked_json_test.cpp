#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "hil/motion/kinematic_trajectory.hpp"
#include "tests/hil/emulate/bench.hpp"

/// A JSON library of others reads what the emulated DVL sends.
namespace drydock::emulate {
namespace water_linked_json_test {

using nlohmann::json;
using rig_config::DeviceKind;
using testing::ElementsAre;

/// Remembers to whom each answer was sent.
class Room final : public Wire {
 public:
  void send(wire::Bytes bytes) override { send_to(every_client, bytes); }
  void send(const wire::CanFrame&) override {}
  void send_to(Client client, wire::Bytes bytes) override {
    said.push_back({client, std::string(bytes.begin(), bytes.end())});
  }
  Client speaker() const override { return asks; }

  struct Said {
    Client to;
    std::string text;
  };
  std::vector<Said> said;
  Client asks = 7;
};

class WaterLinkedJsonDvl : public testing::Test {
 protected:
  WaterLinkedJsonDvl() : trajectory_(under_way()) {
    config_.emulate.latency_s = 0.04;
    make(trajectory_);
  }

  void make(const motion::Trajectory& trajectory) {
    dvl_ = make_emulated_device(config_, trajectory, 1).value();
    now_ = start;
  }

  void run_to(double seconds) {
    for (auto due = dvl_->deadline(); due && *due <= at_s(seconds); due = dvl_->deadline())
      dvl_->tick(*due, room_);
    now_ = at_s(seconds);
  }

  /// What it sends until then, of one type.
  std::vector<json> sent_until(double seconds, const std::string& type) {
    room_.said.clear();
    run_to(seconds);
    std::vector<json> found;
    for (const auto& said : room_.said) {
      EXPECT_TRUE(said.text.ends_with("}\r\n")) << said.text;
      if (json line = json::parse(said.text); line["type"] == type) found.push_back(line);
    }
    return found;
  }
  json report(double seconds = 0.05) { return sent_until(seconds, "velocity").at(0); }

  void say(std::string_view text) {
    dvl_->receive({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, now_, room_);
  }
  json answer_to(std::string_view text) {
    room_.said.clear();
    say(text);
    return room_.said.empty() ? json() : json::parse(room_.said.back().text);
  }
  json set(const std::string& parameters) {
    return answer_to("{\"command\":\"set_config\",\"parameters\":" + parameters + "}");
  }
  json result_of(const std::string& command) {
    return answer_to("{\"command\":\"" + command + "\"}")["result"];
  }

  Frozen trajectory_;
  rig_config::DeviceConfig config_ = device(DeviceKind::dvl, "water-linked-json", 5);
  std::unique_ptr<EmulatedDevice> dvl_;
  Room room_;
  Stamp now_ = start;
};

TEST_F(WaterLinkedJsonDvl, TheKeysStandInTheOrderOfARealLine) {
  run_to(0.05);
  std::vector<std::string> keys;
  const auto& line = room_.said.back().text;
  const auto object = nlohmann::ordered_json::parse(line);
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  EXPECT_THAT(keys, ElementsAre("time", "vx", "vy", "vz", "fom", "covariance", "altitude",
                                "transducers", "velocity_valid", "status", "format", "type",
                                "time_of_validity", "time_of_transmission"));
  EXPECT_EQ(line.find(' '), std::string::npos) << "compact";
  EXPECT_LT(line.size(), 1100U);
}

TEST_F(WaterLinkedJsonDvl, TheReportHoldsTheTruthAndItsAge) {
  const json m = report();
  EXPECT_EQ(m["velocity_valid"], true);
  EXPECT_NEAR(m["vx"], 2.0, 1e-8);
  EXPECT_NEAR(m["vy"], 0.123, 1e-8);
  EXPECT_NEAR(m["vz"], -0.045, 1e-8);
  EXPECT_NEAR(m["altitude"], 30, 0.005);
  EXPECT_EQ(m["time_of_validity"], 1700000000000000);
  EXPECT_EQ(m["time_of_transmission"], 1700000000040000);
  EXPECT_EQ(m["status"], 0);
  EXPECT_EQ(m["format"], "json_v3.3");
}

TEST_F(WaterLinkedJsonDvl, EachBeamIsThePartOfTheVelocityAlongIt) {
  config_.emulate.primary.bias = {0.1, -0.05, 0.02};
  make(trajectory_);
  const json m = report();
  const double tilt = 22.5 * degree;
  EXPECT_NEAR(m["vx"], 2.1, 1e-8);
  for (std::size_t id = 0; id < 4; ++id) {
    const double azimuth = std::array{135, -135, -45, 45}[id] * degree;
    const json& beam = m["transducers"][id];
    EXPECT_EQ(beam["id"], id);
    EXPECT_EQ(beam["beam_valid"], true);
    const double along = std::sin(tilt) * std::cos(azimuth) * m["vx"].get<double>() +
                         std::sin(tilt) * std::sin(azimuth) * m["vy"].get<double>() +
                         std::cos(tilt) * m["vz"].get<double>();
    EXPECT_NEAR(beam["velocity"], along, 1e-7) << id;
    EXPECT_GT(beam["distance"], 30.0) << "along the beam";
  }
}

TEST_F(WaterLinkedJsonDvl, TheMeritIsTheRootOfTheLargestVariance) {
  const json m = report();
  // Four beams of 1.7 mm/s at 22.5 degrees: sigma2 / (2 sin2) across, sigma2 / (4 cos2) along.
  const double sigma2 = 0.0017 * 0.0017, s2 = 0.1464466, c2 = 0.8535534;
  EXPECT_NEAR(m["covariance"][0][0], sigma2 / (2 * s2), 1e-11);
  EXPECT_NEAR(m["covariance"][1][1], sigma2 / (2 * s2), 1e-11);
  EXPECT_NEAR(m["covariance"][2][2], sigma2 / (4 * c2), 1e-11);
  EXPECT_NEAR(m["covariance"][0][2], 0, 1e-11);
  EXPECT_NEAR(m["fom"], std::sqrt(sigma2 / (2 * s2)), 1e-8);
}

TEST_F(WaterLinkedJsonDvl, BeyondItsRangeItHasTheInvalidForms) {
  motion::Truth truth = under_way();
  truth.bed_depth_m = 400;
  const Frozen deep(truth);
  make(deep);
  const json m = report();
  EXPECT_EQ(m["velocity_valid"], false);
  for (const char* key : {"vx", "vy", "vz"}) EXPECT_EQ(m[key], 0) << key;
  EXPECT_EQ(m["altitude"], -1);
  EXPECT_EQ(m["fom"], 2.707);
  EXPECT_EQ(m["transducers"][3]["distance"], -1);
  EXPECT_EQ(m["transducers"][3]["velocity"], 0);
  EXPECT_EQ(m["transducers"][3]["nsd"], -95);
  EXPECT_EQ(m["transducers"][3]["beam_valid"], false);
}

TEST_F(WaterLinkedJsonDvl, TimeIsTheIntervalSinceTheLastReport) {
  const auto reports = sent_until(1, "velocity");
  ASSERT_EQ(reports.size(), 5U);
  for (const json& m : reports) EXPECT_EQ(m["time"], 200);
}

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

/// Straight ahead at 2 m/s, level.
rig_config::MissionConfig straight() {
  rig_config::MissionConfig mission;
  mission.latitude_rad = 47 * degree;
  mission.speed_mps = 2;
  mission.depth_m = 10;
  mission.ocean.bed.depth_m = 40;
  mission.legs = {{.kind = rig_config::LegKind::straight, .duration_s = 100, .speed_mps = 2}};
  return mission;
}

TEST_F(WaterLinkedJsonDvl, DeadReckoningCountsFromTheLastResetInTheAxesOfThatMoment) {
  const motion::KinematicTrajectory ahead(straight(), start);
  config_.mounting_rad = {0, 5 * degree, 0};  // its bow is 5 degrees up
  make(ahead);
  const auto first = sent_until(50, "position_local");
  EXPECT_EQ(first.size(), 251U) << "5 Hz";
  EXPECT_NEAR(first.back()["x"], 100 * std::cos(5 * degree), 0.01) << "99.6 of 100 m";
  EXPECT_NEAR(first.back()["y"], 0, 0.01);
  EXPECT_NEAR(first.back()["z"], 100 * std::sin(5 * degree), 0.01) << "9 m";
  for (const char* angle : {"roll", "pitch", "yaw"}) EXPECT_NEAR(first.back()[angle], 0, 0.01);
  EXPECT_GT(first.back()["std"], first.at(10)["std"]);
  EXPECT_EQ(first.back()["ts"], 1700000050.0);
  EXPECT_EQ(first.back()["status"], 0);

  EXPECT_EQ(answer_to(R"({"command":"reset_dead_reckoning"})")["success"], true);
  const auto then = sent_until(60, "position_local");
  EXPECT_NEAR(then.at(0)["x"], 0.3 * std::cos(5 * degree), 0.001) << "from 0.05 s to 0.2 s";
  EXPECT_NEAR(then.back()["x"], 2 * 9.95 * std::cos(5 * degree), 0.01);
}

}  // namespace water_linked_json_test
}  // namespace drydock::emulate
