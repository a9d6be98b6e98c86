#include "drivers/wire/j1939/mv5.hpp"

#include <gtest/gtest.h>

#include <map>

#include "tests/drivers/wire/can_fixture.hpp"

namespace drydock::wire::mv5 {
namespace mv5_test {

using nlohmann::json;

/// Our key for each signal of the public DBC, and its scale.
const std::map<std::string, std::string> keys{{"PitchAngle", "pitch_deg"},
                                              {"RollAngle", "roll_deg"},
                                              {"PitchAngleCompensation", "pitch_compensation"},
                                              {"RollAngleCompensation", "roll_compensation"},
                                              {"RollPitchMeasurementLatency", "latency_s"},
                                              {"AngularRateMeasurementLatency", "latency_s"},
                                              {"PitchRate", "pitch_rate_degps"},
                                              {"RollRate", "roll_rate_degps"},
                                              {"YawRate", "yaw_rate_degps"},
                                              {"LateralAcceleration", "lateral_mps2"},
                                              {"LongitudinalAcceleration", "longitudinal_mps2"},
                                              {"VerticalAcceleration", "vertical_mps2"}};

/// The signal with the merit of a value.
std::string merit_signal(std::string signal) {
  if (signal.ends_with("Acceleration")) signal.resize(signal.size() - 7);  // ...Accel
  return signal + "FigureOfMerit";
}

/// J1939-71 reserves FBh and more in the highest byte; merits 2 and 3 take a value back.
bool is_number(const json& signals, const std::string& signal, const json& value) {
  const auto raw = value["raw"].get<std::uint32_t>();
  const bool angle = signal.ends_with("Angle"), latency = signal.ends_with("Latency");
  if (signal.ends_with("Compensation")) return true;
  if (raw >> (angle ? 16 : latency ? 0 : 8) >= 0xFB) return false;
  return latency || signals[merit_signal(signal)]["raw"] < 2;
}

TEST(Mv5, EverySignalOfThePublicDbcIsReadWhereItStands) {
  const auto lines = test::lines_of(test::corpus("dbc/expected/microstrain_MV5.jsonl"));
  if (lines.empty()) GTEST_SKIP() << "corpora absent: dbc";
  std::map<std::string, unsigned> numbers, empty;
  for (const std::string& text : lines) {
    const json line = json::parse(text);
    if (!line["sig"].is_object() || line["sig"].empty()) continue;
    char id[9];
    std::snprintf(id, sizeof id, "%08X", line["id"].get<unsigned>());
    const auto messages = test::decode_all<Mv5>(
        {test::frame(std::string(id) + "#" + line["data"].get<std::string>())});
    ASSERT_EQ(messages.size(), 1u) << text;
    const json ours = test::to_json(messages[0]);
    for (const auto& [signal, value] : line["sig"].items()) {
      if (!keys.contains(signal)) continue;
      const json& shown = ours.at(keys.at(signal));
      if (!is_number(line["sig"], signal, value)) {
        EXPECT_TRUE(shown.is_null()) << signal << text;
        ++empty[signal];
        continue;
      }
      const double scale = signal.ends_with("Latency") ? 1e-3 : 1;
      ASSERT_TRUE(shown.is_number()) << signal << text;
      EXPECT_NEAR(shown.get<double>(), value["val"].get<double>() * scale, 1e-9) << signal << text;
      ++numbers[signal];
    }
  }
  EXPECT_EQ(numbers.size(), keys.size());
  EXPECT_GE(empty.size(), 10u);
}

// By hand: 32000 steps are zero; 1/128 deg/s and 0.01 m/s2 a step.
TEST(Mv5, EncodesSaesOrder) {
  AngularRate rate;
  rate.source = default_address;
  rate.rate_radps = {radians(1.0), radians(-0.5), 0.0};
  rate.latency_s = 0.004;
  EXPECT_EQ(test::text_of(encode(rate)), "0CF02AE2#807DC07C007D0008");
  Acceleration acceleration;
  acceleration.source = default_address;
  acceleration.acceleration_mps2 = {0.25, -1.0, 9.81};
  EXPECT_EQ(test::text_of(encode(acceleration)).substr(0, 21), "08F02DE2#197D9C7CD580");
}

}  // namespace mv5_test
}  // namespace drydock::wire::mv5
