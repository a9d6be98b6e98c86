#include "drivers/wire/can/sbg.hpp"

#include <gtest/gtest.h>

#include <map>

#include "tests/drivers/wire/can_fixture.hpp"

namespace drydock::wire::sbg {
namespace sbg_test {

using nlohmann::json;

/// Our key for a signal of SBG's DBC, the step from its unit to ours, and the zero.
struct Field {
  std::string key;
  double scale = 1, zero = 0;
};

constexpr double to_degrees = 180 / 3.14159265358979323846;

const std::map<std::string, Field> fields{{"IMU_INFO.TIME_STAMP", {"device_time_s", 1e-6}},
                                          {"IMU_INFO.STATUS", {"status"}},
                                          {"IMU_INFO.TEMPERATURE", {"temperature_k", 1, 273.15}},
                                          {"IMU_ACCEL.ACCEL_X", {"acceleration_x_mps2"}},
                                          {"IMU_ACCEL.ACCEL_Y", {"acceleration_y_mps2"}},
                                          {"IMU_ACCEL.ACCEL_Z", {"acceleration_z_mps2"}},
                                          {"IMU_GYRO.GYRO_X", {"rate_x_degps", to_degrees}},
                                          {"IMU_GYRO.GYRO_Y", {"rate_y_degps", to_degrees}},
                                          {"IMU_GYRO.GYRO_Z", {"rate_z_degps", to_degrees}},
                                          {"EKF_INFO.TIME_STAMP", {"device_time_s", 1e-6}},
                                          {"EKF_QUAT.Q0", {"w"}},
                                          {"EKF_QUAT.Q1", {"x"}},
                                          {"EKF_QUAT.Q2", {"y"}},
                                          {"EKF_QUAT.Q3", {"z"}},
                                          {"EKF_EULER.ROLL", {"roll_deg", to_degrees}},
                                          {"EKF_EULER.PITCH", {"pitch_deg", to_degrees}},
                                          {"EKF_EULER.YAW", {"yaw_deg", to_degrees}},
                                          {"EKF_POS.LATITUDE", {"latitude_deg"}},
                                          {"EKF_POS.LONGITUDE", {"longitude_deg"}},
                                          {"EKF_ALTITUDE.ALTITUDE", {"mean_sea_level_height_m"}},
                                          {"EKF_ALTITUDE.UNDULATION", {"geoid_separation_m"}},
                                          {"EKF_VEL_NED.VELOCITY_N", {"north_mps"}},
                                          {"EKF_VEL_NED.VELOCITY_E", {"east_mps"}},
                                          {"EKF_VEL_NED.VELOCITY_D", {"down_mps"}},
                                          {"EKF_VEL_BODY.VELOCITY_X", {"forward_mps"}},
                                          {"EKF_VEL_BODY.VELOCITY_Y", {"starboard_mps"}},
                                          {"EKF_VEL_BODY.VELOCITY_Z", {"down_mps"}}};

TEST(Sbg, EverySignalOfTheMakersDbcIsReadWhereItStands) {
  const auto lines = test::lines_of(test::corpus("dbc/expected/sbgCan.jsonl"));
  if (lines.empty()) GTEST_SKIP() << "corpora absent: dbc";
  std::map<std::string, unsigned> compared;
  for (const std::string& text : lines) {
    const json line = json::parse(text);
    const auto name = line["msg"].get<std::string>().substr(std::string("SBG_ECAN_MSG_").size());
    char id[4];
    std::snprintf(id, sizeof id, "%03X", line["id"].get<unsigned>());
    const auto messages = test::decode_all<Sbg>(
        {test::frame(std::string(id) + "#" + line["data"].get<std::string>())});
    if (messages.empty()) continue;
    const json ours = test::to_json(messages[0]);
    for (const auto& [signal, value] : line["sig"].items()) {
      const auto field = fields.find(name + "." + signal);
      ASSERT_NE(field, fields.end()) << name << "." << signal;
      const double expected = value["val"].get<double>() * field->second.scale + field->second.zero;
      EXPECT_NEAR(ours.at(field->second.key).get<double>(), expected,
                  1e-9 * std::max(1.0, std::abs(expected)))
          << text;
      ++compared[field->first];
    }
  }
  EXPECT_EQ(compared.size(), fields.size());
}

// By hand: 0.01 m/s2, 0.001 rad/s, little-endian.
TEST(Sbg, EncodesTheGroupOfTheImu) {
  ImuInfo info;
  info.time_us = 1'500'000;
  EXPECT_EQ(test::text_of(encode(info)), "120#60E3160000000000");
  EXPECT_EQ(test::text_of(encode(ImuAcceleration{{0.25, -1, -9.81}})), "121#19009CFF2BFC");
  EXPECT_EQ(test::text_of(encode(ImuRate{{0.1, -0.001, 2}})), "122#6400FFFFD007");
}

TEST(Sbg, AShortFrameIsCountedAndAnOtherMessageIsNot) {
  Sbg::Decoder decoder;
  EXPECT_FALSE(decoder.receive(test::frame("121#0000000000")));
  EXPECT_FALSE(decoder.receive(test::frame("166#0000000000")));
  EXPECT_FALSE(decoder.receive(test::frame("00000121#000000000000")));
  EXPECT_EQ(decoder.counters().bad_checksums, 1u);
}

}  // namespace sbg_test
}  // namespace drydock::wire::sbg
