#include <gmock/gmock.h>

#include "tests/drivers/capture/captures.hpp"

/// The bases, times and marks of the tables of IXXAT's and Kvaser's programs.
namespace drydock::capture::testing {
namespace tables_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using namespace std::chrono_literals;

std::vector<std::chrono::nanoseconds> times_of(const Outcome& outcome) {
  EXPECT_EQ(outcome.damaged, 0u);
  std::vector<std::chrono::nanoseconds> times;
  for (const Seen& seen : outcome.records) times.push_back(seen.time.value());
  return times;
}

/// The first rows of a trace of MiniMon V3 in a public repository.
TEST(IxxatTable, OfMiniMonReadsAsItsReadersDo) {
  const Outcome outcome = read_capture(
      "ASCII Trace IXXAT MiniMon V3  Version: 1.1.4.4533\nDate: 5/9/2024\nStart time: 2:37:37 PM\n"
      "Stop time: 2:37:37 PM\nOverruns:    \nBaudrate: 500 kbit/s\n"
      "\"Time\",\"Identifier (hex)\",\"Format\",\"Flags\",\"Data (hex)\"\n"
      "\"00:30:06.866\",\"184\",\"Std\",\"\",\"00 06 00 16 75 EE 00 3C\"\n"
      "\"00:30:06.867\",\"300\",\"Std\",\"\",\"00 09 00 07 20 03 00 00\"\n");
  EXPECT_THAT(times_of(outcome), ElementsAre(1806866ms, 1806867ms));
  EXPECT_EQ(outcome.records[0].frame.id, 0x184u);
  EXPECT_THAT(data_of(outcome.records[0]), ElementsAre(0, 6, 0, 0x16, 0x75, 0xEE, 0, 0x3C));
}

TEST(IxxatTable, OfSavvyCanHasEightDigitsForElevenBitsToo) {
  const Seen seen = only(
      "ASCII Trace IXXAT SavvyCAN V220\n\"Time\",\"Identifier (hex)\",\"Format\",\"Flags\","
      "\"Data (hex)\"\n\"9:5:2.025\",\"00000123\",\"Std\",\"\",\"11 22 \"\n");
  EXPECT_FALSE(seen.frame.extended);
  EXPECT_EQ(seen.time, 9h + 5min + 2025ms);
}

TEST(IxxatTable, ColumnsSayTheBaseAndWhetherTimesArePauses) {
  const Outcome outcome = read_capture(
      "\"Bus\",\"No\",\"Time (rel)\",\"State\",\"ID (dec)\",\"DLC\",\"Data (dec)\"\n"
      "\"CAN2\",\"1\",\"00:00:01.500\",\"\",\"291\",\"2\",\"17 255\"\n"
      "\"CAN2\",\"2\",\"00:00:00.250\",\"\",\"291\",\"0\",\"\"\n");
  EXPECT_THAT(times_of(outcome), ElementsAre(1500ms, 1750ms));
  EXPECT_EQ(outcome.records[0].frame.id, 0x123u);
  EXPECT_EQ(outcome.records[0].interface, "can1");
  EXPECT_THAT(data_of(outcome.records[0]), ElementsAre(0x11, 0xFF));
}

/// CANnector Log User Manual 4.01.0091.21000, 6.1: `Time (abs)` is s.ms.us.ns.
TEST(IxxatTable, OfTheCannectorCountsFromItsStartInGroupsOfDigits) {
  const Seen seen = only(
      "Bus;No;Time (abs);State/Channel/Cycle;ID (hex);Length;Data (hex);ASCII\n"
      "CAN 1;1;12.345.678.900;;7DF;2;02 01;..\n");
  EXPECT_EQ(seen.time, 12'345'678'900ns);
}

TEST(IxxatTable, ARowThatIsCutOrDoesNotFitItsLengthIsCounted) {
  const Outcome outcome = read_capture(
      "\"Bus\",\"No\",\"Time (abs)\",\"State\",\"ID (hex)\",\"DLC\",\"Data (hex)\"\n"
      "\"CAN1\",\"1\",\"00:00:01.5\",\"\",\"123\",\"3\",\"11 22\"\n"
      "\"CAN1\",\"1\",\"00:00:01.5\",\"\",\"123\",\"2\",\"11 2\n"
      "\"CAN1\",\"1\",\"00:61:01.5\",\"\",\"123\",\"2\",\"11 22\"\n"
      "\"CAN1\",\"1\",\"00:00:01.5\",\"\",\"123\",\"2\",\"11 22\"\n");
  EXPECT_EQ(outcome.records.size(), 1u);
  EXPECT_EQ(outcome.damaged, 3u);
}

std::string kvaser(const std::string& rows, const std::string& numbers = "DEC") {
  return "CSV CAN data\nFormat of data field;" + numbers + "\nFormat of id field;" + numbers +
         "\nLogging started at;2023-11-14 22:13:20\n"
         "Time;Channel;id;Flags;DLC;Data0;Data1;Data2;Data3;Data4;Data5;Data6;Data7;Counter\n" +
         rows;
}

TEST(KvaserTable, MayHaveSemicolonsDecimalCommasAndDecimalNumbers) {
  const Outcome outcome =
      read_capture(kvaser("7,00000;2;291;2;2;17;255;;;;;;;1\n7,50000;2;291;2;0;;;;;;;;;2\n"));
  EXPECT_THAT(times_of(outcome), ElementsAre(1'700'000'000s, 1'700'000'000'500ms));
  EXPECT_EQ(outcome.records[0].frame.id, 0x123u);
  EXPECT_EQ(outcome.records[0].interface, "can1");
  EXPECT_THAT(data_of(outcome.records[0]), ElementsAre(0x11, 0xFF));
}

TEST(KvaserTable, WithoutItsHeadIsNoneThatSaysItsBase) {
  FrameCapture capture;
  capture.feed(wire::testing::as_bytes(std::string_view(
      "Time,Channel,id,Flags,DLC,Data0,Data1,Counter\n0.00000,1,100,2,2,11,22,1\n")));
  capture.finish();
  EXPECT_FALSE(capture.next());
  EXPECT_EQ(capture.tally().damaged, 1u);
  EXPECT_THAT(std::string(capture.note()), HasSubstr("decimal or hexadecimal"));
}

TEST(KvaserTable, OfPgnsHasNoIdentifiers) {
  FrameCapture capture;
  capture.feed(wire::testing::as_bytes(
      std::string_view("CSV CAN data\nFormat of data field,HEX\nFormat of PGN field,HEX\n"
                       "Time,Channel,PGN,Flags,DLC,Data0,Counter\n0.00000,1,fef1,4,1,11,1\n")));
  capture.finish();
  EXPECT_FALSE(capture.next());
  EXPECT_THAT(std::string(capture.note()), HasSubstr("PGNs"));
}

TEST(KvaserTable, RowsThatDoNotFitAreCounted) {
  const Outcome outcome =
      read_capture(kvaser("0,1;1;800;2;1;11;;;;;;;;1\n0,1;1;7ff;2;2;11;100;;;;;;;1\n"
                          "0,1;0;7ff;2;1;11;;;;;;;;1\n0,1;1;7ff;2;1;11;;;;;;;;1\n",
                          "HEX"));
  EXPECT_EQ(outcome.records.size(), 1u);
  EXPECT_EQ(outcome.damaged, 3u);
}

}  // namespace tables_test
}  // namespace drydock::capture::testing
