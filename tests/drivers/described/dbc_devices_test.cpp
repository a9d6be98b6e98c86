#include <filesystem>
#include <fstream>
#include <set>

#include "tests/drivers/described/dbc_bus.hpp"

/// Emulated sensors on a CAN bus, from a description and a DBC file.
namespace drydock::described::test {
namespace dbc_devices_test {

using emulate::degree;
using measurement::ImuSample;
namespace fs = std::filesystem;

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

}  // namespace dbc_devices_test
}  // namespace drydock::described::test
