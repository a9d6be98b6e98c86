#include <filesystem>
#include <fstream>

#include "hil/fault/wire/faulty_wire.hpp"
#include "tests/drivers/described/dbc_bus.hpp"

/// A multiplexed message with a counter and a checksum, from a description and a DBC file.
namespace drydock::described::test {
namespace dbc_toy_test {

using measurement::DepthSample;
namespace fs = std::filesystem;

/// A pressure and a temperature in turn, with a counter and SAE J1850's CRC in front.
class DbcToy : public testing::Test {
 protected:
  DbcToy() : folder_(fs::path(testing::TempDir()) / ("drydock-dbc-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    std::ofstream(folder_ / "toy.dbc") << R"(VERSION ""
BU_: s
BO_ 256 state: 4 s
 SG_ CRC : 0|8@1+ (1,0) [0|0] "" Vector__XXX
 SG_ COUNTER : 8|4@1+ (1,0) [0|0] "" Vector__XXX
 SG_ page M : 12|4@1+ (1,0) [0|0] "" Vector__XXX
 SG_ pressure m0 : 16|16@1+ (0.1,0) [0|0] "kPa" Vector__XXX
 SG_ temperature m1 : 16|16@1- (0.01,0) [0|0] ")"
                                          "\xB0"  // a degree sign, as most programs write it
                                          R"(C" Vector__XXX
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
  ~DbcToy() override { fs::remove_all(folder_); }
  /// The problems of the description with one message of so many bytes, and what the file says of
  /// its format.
  std::string problems_with(unsigned bytes, const std::string& format) const {
    std::ofstream(folder_ / "toy.dbc") << "BU_: s\nBO_ 256 state: " << bytes
                                       << " s\n SG_ pressure : 0|16@1+ (1,0) [0|0] \"kPa\" s\n"
                                       << format;
    std::ofstream(folder_ / "toy.toml")
        << "[sensor]\ntitle = \"t\"\nkind = \"depth\"\n[protocol]\ndbc = \"toy.dbc\"\n"
           "[[protocol.frames]]\nmessage = \"state\"\n"
           "fields = [{signal = \"pressure\", field = \"pressure_pa\"}]\n";
    const auto loaded = rig_config::load_description((folder_ / "toy.toml").string());
    return loaded ? "" : to_string(loaded.error().front());
  }
  DescriptionPtr toy() const {
    auto loaded = rig_config::load_description((folder_ / "toy.toml").string());
    EXPECT_TRUE(loaded) << (loaded ? "" : to_string(loaded.error().front()));
    return *loaded;
  }

 private:
  fs::path folder_;
};

// The CRCs are those of a bit-by-bit program whose check value of "123456789" is 4Bh.
TEST_F(DbcToy, TwoPagesOfAMultiplexedMessageAreOneSample) {
  Bus bus(toy());
  bus.says(frame("100#0E00DD07"), 1);  // counter 0, page 0: 2013
  EXPECT_TRUE(bus.all.empty());
  bus.says(frame("100#FF116AFF"), 1.001);  // counter 1, page 1: -150
  ASSERT_EQ(bus.all.size(), 1u);
  EXPECT_NEAR(*bus.last<DepthSample>().pressure_pa, 201'300, 1e-6);
  EXPECT_NEAR(*bus.last<DepthSample>().temperature_k, 271.65, 1e-9);
}

/// Vector's numbers of VFrameFormat: 14 is StandardCAN_FD.
TEST_F(DbcToy, AMessageThatIsTooLongForAFrameIsToldHowTheFileSaysCanFd) {
  EXPECT_NE(problems_with(32, "").find("has 32 bytes, allowed: up to 8, which one frame holds; of "
                                       "a frame of CAN FD the DBC file says so: attribute "
                                       "VFrameFormat, 14 (StandardCAN_FD) or 15 (ExtendedCAN_FD)"),
            std::string::npos);
  EXPECT_EQ(problems_with(32,
                          "BA_DEF_ BO_ \"VFrameFormat\" INT 0 15;\n"
                          "BA_DEF_DEF_ \"VFrameFormat\" 0;\n"
                          "BA_ \"VFrameFormat\" BO_ 256 14;\n"),
            "");
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

TEST_F(DbcToy, AnEmulatedToySendsBothPagesAndTheTruthComesBack) {
  Bus bus(toy());
  run(toy(), 10, 5, bus);
  EXPECT_NEAR(static_cast<double>(bus.all.size()), 51, 1);
  EXPECT_TRUE(bus.reports.empty() && bus.refusals.empty());
  EXPECT_NEAR(*bus.last<DepthSample>().depth_m, 20, 0.2);
  EXPECT_TRUE(bus.last<DepthSample>().temperature_k);
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

}  // namespace dbc_toy_test
}  // namespace drydock::described::test
