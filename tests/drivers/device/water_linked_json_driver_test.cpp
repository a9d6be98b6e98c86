#include "tests/drivers/device/support.hpp"

/// The lines are written by hand from Water Linked's description of its keys.
namespace drydock::device::test {
namespace water_linked_json_driver_test {

using namespace std::chrono_literals;
using measurement::BottomVelocity;

const std::string locked = R"("vx":1.234,"vy":-0.056,"vz":0.078)";
const std::string unit = R"("fom":0.003,"covariance":[[1,0,0],[0,1,0],[0,0,1]])";
const std::string times =
    R"("time_of_validity":1795262400123456,"time_of_transmission":1795262400198456)";  // 75 ms

Octets report(const std::string& velocity, const std::string& accuracy, const std::string& stamps,
              const std::string& more = R"("altitude":6.98,"velocity_valid":true,"status":0)",
              const std::string& type = "velocity") {
  return octets("{\"time\":83.4," + velocity + "," + accuracy + "," + more +
                ",\"transducers\":[{\"id\":3,\"velocity\":0.1,\"distance\":10.0,\"rssi\":-30,"
                "\"nsd\":-95,\"beam_valid\":true},{\"id\":1,\"velocity\":0,\"distance\":-1,"
                "\"rssi\":-60,\"nsd\":-95,\"beam_valid\":false}],\"format\":\"json_v3.3\","
                "\"type\":\"" +
                type + "\"," + stamps + "}\r\n");
}

const Octets usual = report(locked, unit, times);
const Octets lost = report(R"("vx":0,"vy":0,"vz":0)", unit, times,
                           R"("altitude":-1,"velocity_valid":false,"status":0)");

DriverOptions tcp() { return options(Kind::dvl, "water-linked-json"); }

std::vector<BottomVelocity> heard(const Octets& bytes, const DriverOptions& o = tcp()) {
  Ear ear;
  byte_driver(o)->receive(bytes, at_s(1), ear);
  return ear.all<BottomVelocity>();
}

TEST(WaterLinkedJsonDriver, VelocityInTheBodyAndAltitude) {
  DriverOptions o = tcp();
  o.mounting = {0, 0, 90 * degree};  // its x axis points to starboard
  const auto m = heard(usual, o).at(0);
  EXPECT_NEAR(m.velocity->x(), 0.056, 1e-12);
  EXPECT_NEAR(m.velocity->y(), 1.234, 1e-12);
  EXPECT_NEAR(m.velocity->z(), 0.078, 1e-12);
  EXPECT_EQ(m.altitude_m, 6.98);
  EXPECT_EQ(m.origin.device_time, 1795262400123456us);
}

TEST(WaterLinkedJsonDriver, ARangeIsTheVerticalPartOfABeamsDistance) {
  const auto m = heard(usual).at(0);
  EXPECT_NEAR(*m.range_m[3], 10 * 0.92388, 1e-5) << "cos 22.5 degrees";
  EXPECT_FALSE(m.range_m[0] || m.range_m[1] || m.range_m[2]);
}

/// A quarter turn about z: the DVL's x is the body's y, its y the body's -x.
TEST(WaterLinkedJsonDriver, TheCovarianceTurnsIntoTheBodyAndComesBeforeTheRigsSigma) {
  DriverOptions o = tcp();
  o.mounting = {0, 0, 90 * degree};
  o.velocity_sigma_mps = 0.5;
  const auto m =
      heard(report(locked, R"("fom":0.003,"covariance":[[4,1,2],[1,9,3],[2,3,16]])", times), o)
          .at(0);
  const Eigen::Matrix3d expected{{9, -1, -3}, {-1, 4, 2}, {-3, 2, 16}};
  ASSERT_TRUE(m.velocity_covariance);
  EXPECT_TRUE(m.velocity_covariance->isApprox(expected, 1e-12)) << *m.velocity_covariance;
  EXPECT_EQ(m.figure_of_merit_mps, 0.003);
  EXPECT_FALSE(heard(lost, o).at(0).velocity_covariance);
}

TEST(WaterLinkedJsonDriver, WithoutAnyAccuracyTheRigsSigmaCounts) {
  DriverOptions o = tcp();
  o.velocity_sigma_mps = 0.5;
  const auto m = heard(report(locked, R"("fom":0)", times), o).at(0);
  EXPECT_FALSE(m.figure_of_merit_mps);
  EXPECT_EQ(m.velocity_covariance, Eigen::Matrix3d(0.25 * Eigen::Matrix3d::Identity()));
}

TEST(WaterLinkedJsonDriver, NoLockIsNoVelocityButALivingDvl) {
  const auto m = heard(lost).at(0);
  EXPECT_FALSE(m.velocity || m.altitude_m || m.figure_of_merit_mps);
}

TEST(WaterLinkedJsonDriver, TheReportsOwnTimesSayHowOldItIs) {
  DriverOptions o = tcp();
  o.latency = 20ms;
  EXPECT_EQ(heard(usual, o).at(0).origin.valid_at, at_s(1) - 75ms);
  for (const char* nonsense : {R"("time_of_validity":20,"time_of_transmission":10)",
                               R"("time_of_validity":0,"time_of_transmission":1795262400198456)",
                               R"("ts":1)", R"("time_of_validity":null,"time_of_transmission":14)"})
    EXPECT_EQ(heard(report(locked, unit, nonsense), o).at(0).origin.valid_at, at_s(1) - 20ms)
        << nonsense;
}

TEST(WaterLinkedJsonDriver, TwoTimesThatAreNoAgeAreReportedOnceUntilTheyAreAgain) {
  Ear ear;
  const auto driver = byte_driver(tcp());
  const auto of = [](const char* validity, const char* transmission) {
    return report(locked, unit,
                  std::string("\"time_of_validity\":") + validity +
                      ",\"time_of_transmission\":" + transmission);
  };
  const auto old = of("1795262400000000", "1795262403000000");
  const auto early = of("1795262400000000", "1795262399900000");
  driver->receive(old + old, at_s(1), ear);
  ASSERT_EQ(ear.reports.size(), 1U);
  EXPECT_EQ(ear.reports[0],
            "the report was sent more than 2 s after it was valid, by its own times: its arrival "
            "and latency_ms of the rig tell its time");
  driver->receive(usual + early, at_s(2), ear);
  ASSERT_EQ(ear.reports.size(), 2U);
  EXPECT_EQ(ear.reports[1].substr(0, 43), "the report was sent before it was valid, by");
}

TEST(WaterLinkedJsonDriver, TheFirstFirmwareIsUnderstoodToo) {
  const auto m = heard(octets("{\"time\":106.3,\"vx\":-0.37,\"vy\":0.0017,\"vz\":-0.0083,"
                              "\"fom\":0.0021,\"altitude\":0.49,\"transducers\":[],"
                              "\"velocity_valid\":true,\"status\":0,\"format\":\"json_v1\"}\r\n"))
                     .at(0);
  EXPECT_EQ(m.velocity->x(), -0.37);
  EXPECT_EQ(m.altitude_m, 0.49);
  EXPECT_EQ(m.figure_of_merit_mps, 0.0021);
  EXPECT_FALSE(m.velocity_covariance);
}

TEST(WaterLinkedJsonDriver, WhatNoMeasurementHoldsIsCountedAndSaid) {
  Ear ear;
  byte_driver(tcp())->receive(
      report(locked, unit, times, R"("velocity_valid":true,"status":0)", "velocity_water") +
          octets("{\"ts\":1.5,\"x\":1,\"y\":2,\"z\":3,\"std\":0.1,\"roll\":0,\"pitch\":0,"
                 "\"yaw\":0,\"type\":\"position_local\",\"status\":0,\"format\":\"json_v3.3\"}\n"),
      at_s(1), ear);
  EXPECT_TRUE(ear.heard.empty());
  ASSERT_EQ(ear.refusals.size(), 2U);
  EXPECT_EQ(ear.refusals[0], "no measurement holds the DVL's velocity through the water");
  EXPECT_EQ(ear.refusals[1], "no measurement holds the DVL's dead reckoning");
}

TEST(WaterLinkedJsonDriver, HeatIsReportedOnce) {
  Ear ear;
  const auto hot = report(locked, unit, times, R"("altitude":1,"velocity_valid":true,"status":3)");
  byte_driver(tcp())->receive(hot + hot, at_s(1), ear);
  EXPECT_EQ(ear.reports, std::vector<std::string>{"the DVL is hot and will shut down soon"});
  EXPECT_EQ(ear.all<BottomVelocity>().size(), 2U);
}

TEST(WaterLinkedJsonDriver, AReportInSeveralReadsIsOne) {
  Ear ear;
  const auto driver = byte_driver(tcp());
  for (std::size_t i = 0; i < usual.size(); i += 100)
    driver->receive(wire::Bytes(usual).subspan(i, std::min<std::size_t>(100, usual.size() - i)),
                    at_s(1 + 1e-4 * static_cast<double>(i)), ear);
  EXPECT_EQ(ear.all<BottomVelocity>().size(), 1U);
}

}  // namespace water_linked_json_driver_test
}  // namespace drydock::device::test
