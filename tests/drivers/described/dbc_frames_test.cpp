#include <filesystem>
#include <fstream>
#include <set>

#include "drivers/device/make_driver.hpp"
#include "drivers/survey/bus_survey.hpp"
#include "drivers/wire/described/frame_codec.hpp"
#include "hil/emulate/lockstep.hpp"
#include "hil/fault/wire/faulty_wire.hpp"
#include "tests/drivers/described/support.hpp"
#include "tests/drivers/device/allocation_count.hpp"
#include "tests/drivers/wire/can_fixture.hpp"
#include "tests/hil/emulate/bench.hpp"

/// Sensors on a CAN bus, from a description and a DBC file.
namespace drydock::described::test {
namespace dbc_frames_test {

using measurement::DepthSample;
using measurement::ImuSample;
using measurement::Kind;
using measurement::Stamp;
using wire::test::frame;
namespace fs = std::filesystem;

constexpr double degree = emulate::degree;

struct Bus final : device::Output {
  explicit Bus(const DescriptionPtr& description, const std::string& protocol = "",
               std::uint8_t address = 0) {
    device::DriverOptions options;
    options.address = address;
    options.kind = description->kind;
    options.protocol = protocol.empty() ? description->name : protocol;
    if (protocol.empty()) options.description = description;
    driver = *device::make_frame_driver(options);
  }
  void says(const wire::CanFrame& one, double at_s) {
    driver->receive(one, Stamp{measurement::from_seconds(at_s)}, *this);
  }
  void publish(const measurement::Measurement& m) override { all.push_back(m); }
  void send(wire::Bytes) override {}
  void send(const wire::CanFrame&) override {}
  void report(std::string_view what) override { reports.emplace_back(what); }
  void refuse(std::string_view why, device::Refusal) override { refusals.emplace_back(why); }
  template <class Sample>
  const Sample& last() const {
    return std::get<Sample>(all.back());
  }

  std::unique_ptr<device::FrameDriver> driver;
  std::vector<measurement::Measurement> all;
  std::vector<std::string> reports, refusals;
};

// Frames by the tables of MT1604P: big-endian, 2^-9 rad/s, 2^-8 m/s2, ticks of 100 us.
const auto xsens_ticks = "005#000003E8", xsens_rate = "032#0033FF800500",
           xsens_force = "034#0180FDC009CF";

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

// By SAE's table: lateral 0.25, longitudinal -1, vertical 9.81 m/s2; pitch 1, roll -0.5, yaw 2
// deg/s with a latency of 4 ms.
const auto mv5_force = "08F02DE2#197D9C7CD58000FF", mv5_rate = "0CF02AE2#807DC07C007E0008";

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

/// A pressure and a temperature in turn, with a counter and SAE J1850's CRC in front.
class InAFolder : public testing::Test {
 protected:
  InAFolder()
      : folder_(fs::path(testing::TempDir()) / ("drydock-dbc-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    std::ofstream(folder_ / "toy.dbc") << R"(VERSION ""
BU_: s
BO_ 256 state: 4 s
 SG_ CRC : 0|8@1+ (1,0) [0|0] "" Vector__XXX
 SG_ COUNTER : 8|4@1+ (1,0) [0|0] "" Vector__XXX
 SG_ page M : 12|4@1+ (1,0) [0|0] "" Vector__XXX
 SG_ pressure m0 : 16|16@1+ (0.1,0) [0|0] "kPa" Vector__XXX
 SG_ temperature m1 : 16|16@1- (0.01,0) [0|0] "degC" Vector__XXX
)";
    std::ofstream(folder_ / "toy.toml") << R"([sensor]
title = "toy"
kind = "depth"
[protocol]
dbc = "toy.dbc"
[[protocol.frames]]
message = "state"
counter = { signal = "COUNTER" }
checksum = { signal = "CRC", kind = "crc8-j1850" }
fields = [
  { signal = "pressure", field = "pressure_pa" },
  { signal = "temperature", field = "temperature_k" },
])";
  }
  ~InAFolder() override { fs::remove_all(folder_); }
  DescriptionPtr toy() const {
    auto loaded = rig_config::load_description((folder_ / "toy.toml").string());
    EXPECT_TRUE(loaded) << (loaded ? "" : to_string(loaded.error().front()));
    return *loaded;
  }

 private:
  fs::path folder_;
};

// The CRCs are those of a bit-by-bit program whose check value of "123456789" is 4Bh.
using DbcToy = InAFolder;

TEST_F(DbcToy, TwoPagesOfAMultiplexedMessageAreOneSample) {
  Bus bus(toy());
  bus.says(frame("100#0E00DD07"), 1);  // counter 0, page 0: 2013
  EXPECT_TRUE(bus.all.empty());
  bus.says(frame("100#FF116AFF"), 1.001);  // counter 1, page 1: -150
  ASSERT_EQ(bus.all.size(), 1u);
  EXPECT_NEAR(*bus.last<DepthSample>().pressure_pa, 201'300, 1e-6);
  EXPECT_NEAR(*bus.last<DepthSample>().temperature_k, 271.65, 1e-9);
}

TEST_F(DbcToy, ADamagedAndAShortFrameAreCountedAndNoValue) {
  Bus bus(toy());
  bus.says(frame("100#0E00DD07"), 1);
  bus.says(frame("100#FF116AFE"), 1.001);
  bus.says(frame("100#FF11"), 1.002);
  EXPECT_TRUE(bus.all.empty());
  EXPECT_EQ(bus.driver->counters().bad_checksums, 2u);
  EXPECT_EQ(bus.driver->counters().bytes_skipped, 6u);
  EXPECT_EQ(bus.driver->counters().bytes_good, 4u);
}

TEST_F(DbcToy, ACounterThatStandsStillIsRefusedAndOneThatJumpsIsTold) {
  Bus bus(toy());
  bus.says(frame("100#0E00DD07"), 1);
  bus.says(frame("100#0E00DD07"), 1.001);
  EXPECT_EQ(bus.refusals.size(), 1u);
  bus.says(frame("100#8705DD07"), 1.010);  // 0, then 5
  EXPECT_EQ(bus.reports.size(), 1u);
  bus.says(frame("100#75166AFF"), 1.011);
  EXPECT_EQ(bus.all.size(), 1u);
}

/// The truth through the emulated device, its bus and its driver.
void run(const DescriptionPtr& description, double rate_hz, double seconds, Bus& bus) {
  const emulate::Frozen truth(emulate::under_way());
  auto config = emulate::device(description->kind, description->name, rate_hz);
  config.description = description;
  emulate::EmulatedBus line(
      500'000, [&](const wire::CanFrame& one, std::size_t, const emulate::Passage& passage) {
        bus.driver->receive(one, passage.ended_at, bus);
      });
  line.add(emulate::make_emulated_device(config, truth, 1).value());
  shell::Lockstep lockstep(emulate::start);
  lockstep.add(line);
  lockstep.run_until(emulate::at_s(seconds));
}

TEST_F(DbcToy, AnEmulatedToySendsBothPagesAndTheTruthComesBack) {
  Bus bus(toy());
  run(toy(), 10, 5, bus);
  EXPECT_NEAR(static_cast<double>(bus.all.size()), 51, 1);
  EXPECT_TRUE(bus.reports.empty() && bus.refusals.empty());
  EXPECT_NEAR(*bus.last<DepthSample>().depth_m, 20, 0.2);
  EXPECT_TRUE(bus.last<DepthSample>().temperature_k);
}

TEST(DbcDescriptions, AnEmulatedSensorSendsASlowMessageAsSeldomAsTheDbcFileSays) {
  const fs::path folder = fs::path(::testing::TempDir()) / "described-cycles";
  fs::create_directories(folder);
  std::ofstream(folder / "cycles.dbc")
      << "VERSION \"\"\nBU_: a\nBO_ 256 fast: 4 a\n SG_ pressure : 0|32@1+ (1,0) [0|0] \"Pa\" a\n"
         "BO_ 257 slow: 2 a\n SG_ heat : 0|16@1+ (0.1,0) [0|0] \"K\" a\n"
         "BA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 65535;\nBA_DEF_DEF_ \"GenMsgCycleTime\" 0;\n"
         "BA_ \"GenMsgCycleTime\" BO_ 256 20;\nBA_ \"GenMsgCycleTime\" BO_ 257 200;\n";
  std::ofstream(folder / "cycles.toml")
      << "[sensor]\ntitle = \"t\"\nkind = \"depth\"\n[protocol]\ndbc = \"cycles.dbc\"\n"
         "[[protocol.frames]]\nmessage = \"fast\"\nsample = \"fast\"\n"
         "fields = [{signal = \"pressure\", field = \"pressure_pa\"}]\n"
         "[[protocol.frames]]\nmessage = \"slow\"\nsample = \"slow\"\n"
         "fields = [{signal = \"heat\", field = \"temperature_k\"}]\n";
  const auto loaded = rig_config::load_description((folder / "cycles.toml").string());
  ASSERT_TRUE(loaded) << to_string(loaded.error().front());
  auto config = emulate::device(Kind::depth, "cycles.toml", 50);
  config.description = *loaded;
  const emulate::Frozen truth(emulate::under_way());
  const auto frames = emulate::record(config, truth, 1.99).frames;
  const auto of = [&](std::uint32_t id) {
    return std::ranges::count_if(frames, [&](const auto& one) { return one.frame.id == id; });
  };
  EXPECT_EQ(of(256), 100);
  EXPECT_EQ(of(257), 10) << "200 ms beside 20 ms";
}

TEST_F(DbcToy, TheFaultBadChecksumDamagesTheChecksumOfADescribedFrame) {
  rig_config::FaultConfig fault;
  fault.kind = rig_config::FaultKind::bad_checksum;
  fault.probability = 1;
  fault::FaultyWire<wire::CanFrame> wire(1, "toy", {}, fault::FrameChecksums(toy()));
  wire.set({{&fault, {}, {}}});
  const auto sent = frame("100#0E00DD07");
  wire.put(sent, {});
  const auto got = wire.take({});
  ASSERT_TRUE(got);
  Bus bus(toy());
  bus.says(*got, 1);
  EXPECT_EQ(bus.driver->counters().bad_checksums, 1u);
  EXPECT_EQ(wire.hits()[rig_config::FaultKind::bad_checksum], 1u);
  auto repaired = *got;
  int changed = 0;
  for (std::size_t i = 0; i < 4; ++i) changed += repaired.data.at(i) != sent.data.at(i);
  EXPECT_EQ(changed, 1) << "only the byte of the checksum";
  wire.put(frame("101#0E00DD07"), {});
  EXPECT_EQ(wire.hits()[rig_config::FaultKind::bad_checksum], 1u) << "a frame without one passes";
}

TEST(DbcDescriptions, EmulatedImusGiveTheTruthBackWithinASteps) {
  // Half a step: Xsens 2^-9 rad/s and 2^-8 m/s2; MV5 2^-7 deg/s and 0.01 m/s2.
  struct Case {
    const char* file;
    double rate_radps, force_mps2;
    int samples;  ///< of 2 s at 100 Hz; a node of J1939 waits 250 ms for its address
  };
  for (const Case& one : {Case{"xsens-dbc.toml", 0x1p-10, 0x1p-9, 201},
                          Case{"mv5-dbc.toml", 0x1p-8 * degree, 0.005, 176}}) {
    Bus bus(shipped(one.file));
    run(shipped(one.file), 100, 2, bus);
    EXPECT_NEAR(static_cast<double>(bus.all.size()), one.samples, 2) << one.file;
    EXPECT_TRUE(bus.reports.empty() && bus.refusals.empty()) << one.file;
    const Eigen::Vector3d rate(0.01, -0.02, 0.03), force(0.7, -0.5, -9.78);
    const auto& sample = bus.last<ImuSample>();
    EXPECT_LT((sample.angular_rate - rate).cwiseAbs().maxCoeff(), one.rate_radps * 1.001);
    EXPECT_LT((sample.specific_force - force).cwiseAbs().maxCoeff(), one.force_mps2 * 1.001);
  }
}

TEST(DbcDescriptions, AnEmulatedMv5SendsFromTheAddressOfTheRig) {
  const emulate::Frozen truth(emulate::under_way());
  auto config = emulate::device(Kind::imu, "mv5-dbc.toml", 10);
  config.description = shipped("mv5-dbc.toml");
  config.address = 0x31;
  const auto frames = emulate::record(config, truth, 0.35).frames;
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_EQ(frames[0].frame.id, 0x18EEFF31u) << "J1939-81: it claims, then waits 250 ms";
  // PGN 61482 with priority 3 and 61485 with priority 2, the identifiers of the maker's table.
  EXPECT_EQ(frames[1].frame.id, 0x0CF02A31u);
  EXPECT_EQ(frames[2].frame.id, 0x08F02D31u);
}

TEST(DbcDescriptions, AnEmulatedMv5WhoseAddressIsTakenMovesAndItsDriverFollows) {
  const emulate::Frozen truth(emulate::under_way());
  auto config = emulate::device(Kind::imu, "mv5-dbc.toml", 10);
  config.description = shipped("mv5-dbc.toml");
  config.address = 0x90;
  Bus bus(config.description, "", 0x90);
  std::set<std::uint32_t> senders;
  emulate::EmulatedBus line(
      500'000, [&](const wire::CanFrame& one, std::size_t, const emulate::Passage& passage) {
        if ((one.id >> 8 & 0xFFFF) == 0xF02A) senders.insert(one.id & 0xFF);
        bus.driver->receive(one, passage.ended_at, bus);
      });
  line.add(emulate::make_emulated_device(config, truth, 1).value());
  shell::Lockstep lockstep(emulate::start);
  lockstep.add(line);
  lockstep.run_until(emulate::at_s(2));
  line.receive(frame("18EEFF90#0000000000000000"), emulate::at_s(2));  // the lowest NAME wins
  lockstep.run_until(emulate::at_s(4));
  EXPECT_EQ(senders, (std::set<std::uint32_t>{0x80, 0x90}));
  EXPECT_GE(bus.all.size(), 33u) << "17 before, 17 after a silence of 250 ms";
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
