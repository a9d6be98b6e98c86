#include "estimators/external/step_line.hpp"

#include <gtest/gtest.h>

#include "estimators/external/hello.hpp"

namespace drydock::external {
namespace step_line_test {

measurement::Origin origin(std::uint16_t device, std::int64_t valid, std::int64_t received) {
  measurement::Origin origin;
  origin.device = device;
  origin.valid_at = measurement::stamp_from_ns(valid);
  origin.received_at = measurement::stamp_from_ns(received);
  return origin;
}

/// The expected texts stand in docs/build/external-estimator.md, where they are broken to be read.
TEST(StepLine, IsTheExampleOfThePage) {
  measurement::ImuSample imu;
  imu.origin = origin(0, 1795593600010000000, 1795593600010444000);
  imu.specific_force = {0.01, -0.02, -9.8};
  const std::vector<std::string> names{"imu"};
  const std::vector<pipeline::Sample> samples{imu};
  StepLines lines(names);
  EXPECT_EQ(
      lines.line_of({1, measurement::stamp_from_ns(1795593600060000000), samples}),
      R"({"step":1,"now_ns":1795593600060000000,"measurements":[{"device":"imu","type":"imu",)"
      R"("valid_at_ns":1795593600010000000,"received_at_ns":1795593600010444000,)"
      R"("specific_force_mps2":[0.01,-0.02,-9.8],"angular_rate_degps":[0,0,0]}]})");
}

TEST(StepLine, AStepWithoutMeasurementsHasAnEmptyArray) {
  const std::vector<std::string> names;
  StepLines lines(names);
  EXPECT_EQ(lines.line_of({12, measurement::stamp_from_ns(5), {}}),
            R"({"step":12,"now_ns":5,"measurements":[]})");
}

TEST(StepLine, EachMeasurementNamesItsDevice) {
  measurement::DepthSample depth;
  depth.origin = origin(1, 3, 4);
  depth.depth_m = 12.5;
  measurement::WaterSpeed speed;
  speed.origin = origin(0, 3, 4);
  speed.longitudinal_mps = 2;
  const std::vector<std::string> names{"log", "keel"};
  const std::vector<pipeline::Sample> samples{speed, depth};
  StepLines lines(names);
  const std::string line{lines.line_of({2, measurement::stamp_from_ns(5), samples})};
  EXPECT_NE(line.find(R"({"device":"log","type":"water_speed",)"), std::string::npos) << line;
  EXPECT_NE(line.find(R"({"device":"keel","type":"depth",)"), std::string::npos) << line;
  EXPECT_NE(line.find(R"("depth_m":12.5)"), std::string::npos) << line;
}

TEST(Hello, IsTheExampleOfThePage) {
  const Hello hello{.rig = "demo",
                    .estimator = "mine",
                    .gives = Gives::attitude,
                    .step_s = 0.05,
                    .lockstep = true,
                    .devices = {{"imu", "imu", 100, {}, {3.14159265358979323846, 0, 0}}}};
  EXPECT_EQ(line_of(hello),
            R"({"drydock":1,"rig":"demo","estimator":"mine","gives":"attitude","step_s":0.05,)"
            R"("lockstep":true,"devices":[{"name":"imu","kind":"imu","rate_hz":100.0,)"
            R"("lever_arm_m":[0.0,0.0,0.0],"mounting_deg":[180.0,0.0,0.0]}]})");
}

TEST(Hello, AnotherVersionIsRefusedWithBothVersions) {
  EXPECT_EQ(fault_of_hello(R"({"drydock":1})"), "");
  EXPECT_EQ(fault_of_hello(R"({"drydock":1,"name":"anything else"})"), "");
  EXPECT_EQ(fault_of_hello(R"({"drydock":2})"), "speaks version 2 of the protocol, allowed: 1");
  for (const auto* bad : {"", "{}", "hello", R"({"drydock":"1"})", "[1]"})
    EXPECT_NE(fault_of_hello(bad), "") << bad;
}

}  // namespace step_line_test
}  // namespace drydock::external
