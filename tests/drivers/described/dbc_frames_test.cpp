#include <filesystem>

#include "drivers/survey/bus_survey.hpp"
#include "tests/drivers/described/dbc_bus.hpp"
#include "tests/drivers/device/allocation_count.hpp"

/// Sensors on a CAN bus, from a description and a DBC file.
namespace drydock::described::test {
namespace dbc_frames_test {

using emulate::degree;
using measurement::ImuSample;
namespace fs = std::filesystem;

TEST(DbcDescriptions, AnXsensGivesRateForceAndDeviceTimeOfItsTables) {
  Bus bus(shipped("xsens-dbc.toml"));
  bus.says(frame(xsens_ticks), 1);
  bus.says(frame("006#0007"), 1.0004);
  bus.says(frame(xsens_rate), 1.0008);
  bus.says(frame(xsens_force), 1.0012);
  ASSERT_EQ(bus.all.size(), 1u);
  const auto& sample = bus.last<ImuSample>();
  const Eigen::Vector3d rate(0.099609375, -0.25, 2.5), force(1.5, -2.25, 9.80859375);
  EXPECT_LT((sample.angular_rate - rate).norm(), 1e-12);
  EXPECT_LT((sample.specific_force - force).norm(), 1e-12);
  EXPECT_EQ(sample.origin.device_time, std::chrono::milliseconds{100});
  EXPECT_EQ(sample.origin.received_at, Stamp{measurement::from_seconds(1.0012)});
  EXPECT_LT(sample.origin.valid_at, Stamp{measurement::from_seconds(1)})
      << "before the first frame";
}

TEST(DbcDescriptions, AnXsensWhoseStatusSaysClippingGivesNoSample) {
  Bus bus(shipped("xsens-dbc.toml"));
  bus.says(frame("011#00000803"), 1);  // bit 11: the rate about x
  bus.says(frame(xsens_rate), 1.0004);
  bus.says(frame(xsens_force), 1.0008);
  EXPECT_TRUE(bus.all.empty());
  EXPECT_EQ(bus.refusals.size(), 1u);
  bus.says(frame("011#00000003"), 1.01);
  bus.says(frame(xsens_rate), 1.0104);
  bus.says(frame(xsens_force), 1.0108);
  EXPECT_EQ(bus.all.size(), 1u);
}

TEST(DbcDescriptions, FramesOfTwoSamplesNeverMixAndTheLostOneIsTold) {
  Bus bus(shipped("xsens-dbc.toml"));
  bus.says(frame(xsens_rate), 1);
  bus.says(frame(xsens_rate), 1.004);  // the force between was lost
  EXPECT_EQ(bus.refusals.size(), 1u);
  bus.says(frame(xsens_force), 1.010);  // 6 ms: later than the 5 ms of a sample
  EXPECT_TRUE(bus.all.empty());
  EXPECT_EQ(bus.refusals.size(), 2u);
}

TEST(DbcDescriptions, AnMv5OfAnyAddressGivesTheAxesOfItsHousing) {
  for (const std::string address : {"E2", "31"}) {
    const auto from = [&](std::string text) { return frame(text.replace(6, 2, address)); };
    Bus bus(shipped("mv5-dbc.toml"));
    bus.says(from(mv5_force), 0.9995);
    bus.says(from(mv5_rate), 1);
    ASSERT_EQ(bus.all.size(), 1u) << address;
    const auto& sample = bus.last<ImuSample>();
    EXPECT_LT((sample.specific_force - Eigen::Vector3d(-1, 0.25, 9.81)).norm(), 1e-9);
    EXPECT_LT((sample.angular_rate / degree - Eigen::Vector3d(-0.5, 1, 2)).norm(), 1e-9);
    const double age_s =
        measurement::seconds(Stamp{measurement::from_seconds(1)} - sample.origin.valid_at);
    EXPECT_NEAR(age_s, 0.0045, 0.0001) << "the stated 4 ms before a frame of about 0.5 ms";
  }
}

TEST(DbcDescriptions, WhatJ1939CallsNotAvailableIsNoValue) {
  Bus bus(shipped("mv5-dbc.toml"));
  bus.says(frame("08F02DE2#FFFF9C7CD58000FF"), 0.9995);  // the lateral force: FFFFh
  bus.says(frame(mv5_rate), 1);
  bus.says(frame(mv5_force), 1.0095);
  bus.says(frame("0CF02AE2#807DC07C007E0208"), 1.01);  // merit of the pitch rate: error
  EXPECT_TRUE(bus.all.empty());
  EXPECT_EQ(bus.refusals.size(), 2u);
}

TEST(DbcDescriptions, ASecondSenderOfTheSameGroupsIsNotMixedIn) {
  Bus bus(shipped("mv5-dbc.toml"));
  bus.says(frame(mv5_force), 0.9995);
  bus.says(frame("0CF02A31#807DC07C007E0008"), 1);
  EXPECT_TRUE(bus.all.empty());
  bus.says(frame(mv5_rate), 1.0005);
  EXPECT_EQ(bus.all.size(), 1u);
}

constexpr std::string_view aceinna = R"([sensor]
title = "Aceinna MTLT305D"
kind = "imu"
[protocol]
dbc = "aceinna.dbc"
[[protocol.frames]]
message = "angular_rate"
fields = [
  { signal = "rate_x_degps", field = "rate_x_degps" },
  { signal = "rate_y_degps", field = "rate_y_degps" },
  { signal = "rate_z_degps", field = "rate_z_degps" },
  { signal = "latency_s", field = "age_s", optional = true },
]
[[protocol.frames]]
message = "acceleration"
fields = [
  { signal = "acceleration_x_mps2", field = "force_x_mps2" },
  { signal = "acceleration_y_mps2", field = "force_y_mps2" },
  { signal = "acceleration_z_mps2", field = "force_z_mps2" },
])";

TEST(DbcDescriptions, ARealAceinnaMeasuresTheSameAsThroughItsOwnDriver) {
  const auto log = wire::test::corpus("can_imu/aceinna_mtlt_real.candump.log");
  if (!fs::exists(log)) GTEST_SKIP() << "needs the corpora";
  const auto description = test::described(aceinna);
  Bus ours(description), own(description, "aceinna");
  double at_s = 1;
  for (const auto& one : wire::test::frames_of_log(log)) {
    ours.says(one, at_s);
    own.says(one, at_s);
    at_s += 0.001;
  }
  ASSERT_EQ(own.all.size(), 4u) << "the angular rates of the log";
  ASSERT_EQ(ours.all.size(), own.all.size());
  for (std::size_t i = 0; i < own.all.size(); ++i) {
    const auto &a = std::get<ImuSample>(ours.all[i]), &b = std::get<ImuSample>(own.all[i]);
    ASSERT_LT((a.angular_rate - b.angular_rate).norm(), 1e-12) << i;
    ASSERT_LT((a.specific_force - b.specific_force).norm(), 1e-12) << i;
    ASSERT_EQ(a.origin.valid_at, b.origin.valid_at) << i;
    ASSERT_EQ(a.origin.received_at, b.origin.received_at) << i;
  }
}

TEST(DbcDescriptions, NoFrameAllocates) {
  for (const char* file : {"xsens-dbc.toml", "mv5-dbc.toml"}) {
    Bus bus(shipped(file));
    bus.all.reserve(1000);
    const auto frames = std::array{frame(xsens_ticks), frame(xsens_rate), frame(xsens_force),
                                   frame(mv5_force), frame(mv5_rate)};
    const device::test::AllocationCount allocations;
    for (int i = 0; i < 500; ++i)
      bus.says(frames[static_cast<std::size_t>(i) % frames.size()], 1 + i * 0.001);
    EXPECT_EQ(allocations.so_far(), 0u) << file;
    EXPECT_GE(bus.all.size(), 99u) << file;
  }
}

TEST(DbcDescriptions, AProbeFindsADescribedSensorOnItsBus) {
  survey::BusSurvey survey({shipped("mv5-dbc.toml"), shipped("keller.toml")});
  for (int i = 0; i < 20; ++i) {
    survey.receive(frame(mv5_force), Stamp{measurement::from_seconds(1 + i * 0.01)});
    survey.receive(frame(mv5_rate), Stamp{measurement::from_seconds(1.0005 + i * 0.01)});
  }
  const auto nodes = survey.nodes();
  ASSERT_EQ(nodes.size(), 1u);
  ASSERT_EQ(nodes[0].sensors.size(), 1u);
  EXPECT_EQ(nodes[0].sensors[0].protocol, "mv5-dbc.toml");
}

}  // namespace dbc_frames_test
}  // namespace drydock::described::test
