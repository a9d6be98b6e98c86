#include "drivers/recordings/record/recorder.hpp"

#include <gmock/gmock.h>
#include <stdlib.h>

#include <numbers>
#include <thread>

#include "drivers/recordings/record/recording.hpp"
#include "tests/drivers/recordings/mcap/read_back.hpp"

namespace drydock::record {
namespace recorder_test {

using namespace measurement;

constexpr Stamp start = stamp_from_ns(1'700'000'000'000'000'000);

/// A recorder with a file in a folder of this test.
class RecorderTest : public testing::Test {
 protected:
  RecorderTest() {
    auto name = (std::filesystem::temp_directory_path() / "drydock-record-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    path_ = folder_ / "dive.mcap";
    options_.links = {{"pty:dvl?baud=115200", "dvl", false, {"dvl"}},
                      {"can:auto?name=can0", "can0", true, {"imu", "depth"}}};
    options_.devices = {{"dvl", bus::Kind::dvl},
                        {"imu", bus::Kind::imu},
                        {"depth", bus::Kind::depth},
                        {"gps", bus::Kind::gnss}};
    options_.estimators = {"leveling"};
    options_.innovations = {{0, 0}};
    options_.versions = {{"drydock", "0.1.0"}};
    options_.attachments = {{0, 0, "rig.toml", "application/toml", "[rig]\nname = \"x\"\n"}};
  }
  ~RecorderTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_, path_;
  RecorderOptions options_;
};

Origin origin(std::uint16_t device, int ms) {
  Origin origin;
  origin.device = device;
  origin.valid_at = start + std::chrono::milliseconds{ms};
  origin.received_at = origin.valid_at + std::chrono::milliseconds{3};
  return origin;
}

TEST_F(RecorderTest, RawAndUnderstoodAreReadByOtherPeoplesDecoders) {
  Recorder recorder(mcap::file_sink(path_).value(), options_);
  const std::array<std::uint8_t, 4> bytes{0x7F, 0x7F, 1, 2};
  recorder.on_bytes("pty:dvl?baud=115200", shell::Direction::received, bytes, start);
  wire::CanFrame frame;
  frame.id = 0x181;
  frame.size = 2;
  frame.data[1] = 9;
  recorder.on_frame("can:auto?name=can0", shell::Direction::sent, frame, start);
  recorder.topics().publish(ImuSample{origin(1, 10), {0.5, -0.25, -9.81}, {1, 2, 3}});
  BottomVelocity dvl;
  dvl.origin = origin(0, 20);
  dvl.velocity = Eigen::Vector3d{1.5, 0.1, -0.2};
  recorder.topics().publish(dvl);
  GnssFix fix;
  fix.origin = origin(3, 30);
  fix.position = Geodetic{std::numbers::pi / 4, -std::numbers::pi / 2};
  recorder.topics().publish(fix);
  recorder.topics().publish(bus::Attitude{start, 0.1, 0.2, {}, {}}, 0);
  const std::vector<bus::DeviceStatus> health{{bus::Level::warn, "dvl", "no bottom lock", "", {}}};
  recorder.topics().publish(health, start);
  ASSERT_FALSE(recorder.finish());
  EXPECT_EQ(recorder.status().lost, 0U);

  DRYDOCK_NEEDS_NODE();
  auto found = mcap::test::read_back(path_);
  ASSERT_FALSE(found.contains("indexedError")) << found["indexedError"];
  auto& topics = found["indexed"]["topics"];
  EXPECT_EQ(topics["/raw/serial/dvl"]["last"]["data"].dump(), "[127,127,1,2]");
  EXPECT_EQ(topics["/raw/serial/dvl"]["last"]["stamp"]["sec"], 1'700'000'000);
  EXPECT_EQ(topics["/raw/serial/dvl"]["metadata"]["link"], "pty:dvl?baud=115200");
  EXPECT_EQ(topics["/raw/can/can0"]["last"]["id"], 0x181);
  EXPECT_EQ(topics["/raw/can/can0"]["last"]["direction"], 1);
  EXPECT_EQ(topics["/raw/can/can0"]["last"]["data"].dump(), "[0,9]");
  EXPECT_EQ(topics["/raw/can/can0"]["metadata"]["devices"], "imu,depth");
  auto& imu = topics["/imu/data"];
  EXPECT_EQ(imu["type"], "sensor_msgs/msg/Imu");
  EXPECT_EQ(imu["last"]["linear_acceleration"]["z"], 9.81);  // forward-left-up
  EXPECT_EQ(imu["last"]["header"]["frame_id"], "imu_link");
  EXPECT_EQ(imu["last"]["header"]["stamp"]["nsec"],
            10'000'000);                                 // valid_at; nsec is that reader's word
  EXPECT_EQ(imu["logTimes"][0], "1700000000013000000");  // received_at
  EXPECT_EQ(imu["metadata"]["topic_type_hash"],
            "RIHS01_7d9a00ff131080897a5ec7e26e315954b8eae3353c3f995c55faf71574000b5b");
  EXPECT_EQ(topics["/dvl/data"]["type"], "marine_acoustic_msgs/msg/Dvl");
  EXPECT_EQ(topics["/dvl/data"]["last"]["velocity"]["x"], 1.5);
  EXPECT_EQ(topics["/gps/fix"]["last"]["latitude"], 45.0);
  EXPECT_EQ(topics["/estimate/leveling"]["count"], 1);
  EXPECT_EQ(topics["/diagnostics"]["last"]["status"][0]["message"], "no bottom lock");
  EXPECT_EQ(found["indexed"]["attachments"][0]["name"], "rig.toml");
  EXPECT_EQ(found["indexed"]["metadata"][0]["values"]["drydock"], "0.1.0");
  EXPECT_EQ(found["indexed"]["metadata"][1]["values"]["messages_lost"], "0");
}

TEST_F(RecorderTest, InnovationsAndFaultsAreReadByOtherPeoplesDecoders) {
  Recorder recorder(mcap::file_sink(path_).value(), options_);
  bus::Innovation innovation{start, 0, 0, {}};
  innovation.rows = {{0.3, 0.1, false}, {-0.2, 0.1, true}};
  recorder.topics().publish(innovation);
  innovation.device = 1;  // nothing is compared with an IMU
  recorder.topics().publish(innovation);
  const auto later = start + std::chrono::seconds{9};
  const std::vector<bus::Fault> faults{
      {"dvl", "bit-errors", "one bit in 1000 is wrong", start, {}},
      {"gps", "silence", "says nothing", start, later + std::chrono::seconds{1}}};
  recorder.topics().publish(faults, later);
  ASSERT_FALSE(recorder.finish());

  DRYDOCK_NEEDS_NODE();
  auto topics = mcap::test::read_back(path_)["indexed"]["topics"];
  auto& told = topics["/drydock/leveling/innovation/dvl"];
  EXPECT_EQ(told["count"], 1);
  EXPECT_EQ(told["type"], "drydock/msg/Innovation");
  auto& last = told["last"];
  EXPECT_EQ(last["source"], "dvl");
  EXPECT_EQ(last["axes"], "forward, starboard, down");
  EXPECT_EQ(last["unit"], "m/s");
  EXPECT_EQ(last["header"]["stamp"]["sec"], 1'700'000'000);
  EXPECT_EQ(last["rows"], 2);
  EXPECT_EQ(last["innovation"].dump(), R"([0.3,-0.2,"NaN"])");
  EXPECT_EQ(last["sigma"].dump(), R"([0.1,0.1,"NaN"])");
  EXPECT_EQ(last["used"].dump(), "[false,true,false]");
  EXPECT_NEAR(last["nis"].get<double>(), 13, 1e-12);  // 3^2 + 2^2
  auto& fault = topics["/drydock/faults"]["last"]["faults"];
  EXPECT_EQ(fault[0]["fault"], "bit-errors");
  EXPECT_EQ(fault[0]["in_force"], true);
  EXPECT_EQ(fault[0]["until_known"], false);
  EXPECT_EQ(fault[1]["device"], "gps");
  EXPECT_EQ(fault[1]["since"]["sec"], 1'700'000'000);
  EXPECT_EQ(fault[1]["until_known"], true);
  EXPECT_EQ(fault[1]["until"]["sec"], 1'700'000'010);
}

TEST_F(RecorderTest, WhatIsOlderThanASecondSurvivesAKilledProcess) {
  auto* killed = new Recorder(mcap::file_sink(path_).value(), options_);
  const std::array<std::uint8_t, 1> byte{7};
  for (int ms = 0; ms <= 5500; ms += 100)
    killed->on_bytes("pty:dvl?baud=115200", shell::Direction::received, byte,
                     start + std::chrono::milliseconds{ms});
  while (killed->status().bytes < 1000) std::this_thread::yield();
  // It is never finished and never deleted. The present file is what a killed process leaves.
  DRYDOCK_NEEDS_NODE();
  auto found = mcap::test::read_back(path_);
  EXPECT_TRUE(found.contains("indexedError"));
  EXPECT_GE(found["streamed"]["counts"]["Message"], 50);
  killed->finish();
  delete killed;
}

TEST_F(RecorderTest, AClockThatIsSetBackDelaysNoBlock) {
  Recorder recorder(mcap::file_sink(path_).value(), options_);
  const std::array<std::uint8_t, 1> byte{7};
  recorder.on_bytes("pty:dvl?baud=115200", shell::Direction::received, byte, start);
  recorder.tick(start - std::chrono::hours{1});
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds{5};
  while (recorder.status().messages < 1 && std::chrono::steady_clock::now() < patience)
    std::this_thread::yield();
  EXPECT_EQ(recorder.status().messages, 1U);
}

/// The clock is set back by an hour 5 s after the start, and the devices go on.
TEST_F(RecorderTest, TimesGoOnWhereTheHostsClockIsSetBack) {
  {
    Recorder recorder(mcap::file_sink(path_).value(), options_);
    const std::array<std::uint8_t, 1> byte{7};
    for (int s = 0; s < 10; ++s) {
      const auto at = start + std::chrono::seconds{s < 5 ? s : s - 3600};
      recorder.on_bytes("pty:dvl?baud=115200", shell::Direction::received, byte, at);
      ImuSample sample;
      sample.origin.device = 1;
      sample.origin.valid_at = sample.origin.received_at = at;
      recorder.topics().publish(sample);
    }
    EXPECT_FALSE(recorder.finish());
    EXPECT_THAT(recorder.clock_note(), testing::HasSubstr("set back once, by 3599.000 s"));
  }
  auto recording = Recording::open(path_.string()).value();
  Stamp last = start;
  int events = 0;
  while (const auto event = recording.next()) {
    const auto* raw = std::get_if<RawEvent>(&*event);
    const Stamp at = raw != nullptr ? raw->at() : std::get<Understood>(*event).at;
    EXPECT_GE(at, last);
    last = at;
    ++events;
  }
  EXPECT_EQ(events, 20);
  EXPECT_EQ(last, start + std::chrono::seconds{8}) << "without the second in which it was set";
  EXPECT_THAT(recording.clock_note(), testing::HasSubstr("set back once, by 3599.000 s"));
}

TEST_F(RecorderTest, AFailedFileCostsMessagesNotTheDrivers) {
  int offered = 0;
  const auto full = [&](mcap::Bytes) {
    ++offered;
    return offered < 20
               ? boost::system::error_code{}
               : boost::system::errc::make_error_code(boost::system::errc::no_space_on_device);
  };
  options_.when_behind = WhenBehind::wait;
  Recorder recorder(full, options_);
  const std::array<std::uint8_t, 1> byte{7};
  for (int s = 0; s < 60; ++s)
    recorder.on_bytes("pty:dvl?baud=115200", shell::Direction::received, byte,
                      start + std::chrono::seconds{s});
  EXPECT_EQ(recorder.finish(), boost::system::errc::no_space_on_device);
  EXPECT_GT(recorder.status().lost, 20U);
  EXPECT_EQ(recorder.status().messages + recorder.status().lost, 60U);
}

}  // namespace recorder_test
}  // namespace drydock::record
