#include "drivers/wire/can/slcan.hpp"
#include "drivers/wire/can/slcan_report.hpp"
#include "tests/hil/survive/bench.hpp"

/// A CAN controller goes bus-off and restarts, in real time.
namespace drydock::fault::testing {
namespace bus_test {

const char* const bus = "memory-can:survive-bus";

TEST(BusOff, CutsTheDriversOffAndTheyStreamAfterTheRestart) {
  Bench bench(bus_depth(bus));
  ASSERT_TRUE(bench.reaches(State::streaming));
  bench.set(fault_of("depth", FaultKind::bus_off, 1.0));
  ASSERT_TRUE(bench.reaches(State::stale));
  EXPECT_EQ(bench.health().error_frames, 1u);
  EXPECT_NE(std::string(bench.health().last_error.view()).find("bus-off"), std::string::npos)
      << bench.health().last_error.view();
  ASSERT_TRUE(bench.reaches(State::streaming));
  EXPECT_TRUE(bench.until([&] { return bench.health().error_frames == 2; }));  // restarted
  EXPECT_EQ(bench.health().reopened, 0u);  // the bus itself never disappeared
}

TEST(BusOff, ErrorFramesAreCountedAndMakeNoLine) {
  Bench bench(bus_depth(bus));
  ASSERT_TRUE(bench.reaches(State::streaming));
  const auto lines = bench.lines.size();
  FaultConfig errors = fault_of("depth", FaultKind::error_frames);
  errors.amount[0] = 200;
  bench.set(errors);
  ASSERT_TRUE(bench.until([&] { return bench.health().error_frames >= 100; }));
  EXPECT_EQ(bench.lines.size(), lines);
  EXPECT_EQ(bench.health().state, State::streaming);
  bench.clear();
  bench.pass(50ms);
  const auto counted = bench.health().error_frames;
  bench.pass(200ms);
  EXPECT_EQ(bench.health().error_frames, counted);
}

// An automatic bus without vcan is slcan on a pty. There the adapter reports the controller's
// state.
TEST(BusOff, IsToldOverASerialAdapterAsWell) { expect_bus_off_told("can:auto?name=survive0"); }

// The examples in the comments of the Linux driver: bus-off with both counters at 256; active with
// 57 and 33; no acknowledge; bit 0, CRC and transmit overrun together.
TEST(SlcanReport, IsReadAsTheLinuxDriverReadsIt) {
  using wire::slcan::error_frame_of;
  EXPECT_EQ(error_frame_of("sb256256")->id, 0x040u);
  EXPECT_EQ(error_frame_of("sa057033")->id, 0x100u);
  EXPECT_EQ(error_frame_of("e1a")->id, 0x020u);
  const auto three = error_frame_of("e3bcO");
  ASSERT_TRUE(three);
  EXPECT_TRUE(three->error);
  EXPECT_EQ(three->id, 0x008u | 0x004u);
  EXPECT_EQ(three->data[1], 0x02);
  EXPECT_EQ(three->data[2], 0x08);
  EXPECT_EQ(three->data[3], 0x08);
  for (const char* other : {"", "s", "e", "e0", "e2b", "e1x", "sx256256", "sb25625", "sb2562566",
                            "s031C", "V1013", "t1230"})
    EXPECT_FALSE(error_frame_of(other)) << other;
}

TEST(SlcanReport, OfEveryErrorThatItCanTellComesBackTheSame) {
  for (const char* line : {"sb256256\r", "sa000000\r", "sp128128\r", "sw096096\r", "e1b\r", "e1B\r",
                           "e1f\r", "e1s\r", "e1c\r", "e1a\r", "e1o\r", "e1O\r"}) {
    const std::string text = line;
    const auto frame =
        wire::slcan::error_frame_of(std::string_view(text).substr(0, text.size() - 1));
    ASSERT_TRUE(frame) << text;
    EXPECT_EQ(wire::slcan::report_of(*frame), text);
    EXPECT_EQ(wire::Slcan::scan(link::testing::bytes(text)).kind, wire::Scan::Kind::frame) << text;
  }
}

}  // namespace bus_test
}  // namespace drydock::fault::testing
