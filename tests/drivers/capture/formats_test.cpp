#include <gmock/gmock.h>

#include "tests/drivers/capture/captures.hpp"

/// Rare lines of the other text formats.
namespace drydock::capture::testing {
namespace formats_test {

using ::testing::ElementsAre;
using namespace std::chrono_literals;

TEST(CandumpLogFile, FindsTheGoodLineGluedBehindATornOneAndCountsTheDamage) {
  const Outcome outcome =
      read_capture("(1.0) can0 123#00\n(1795257228.4347(2.000000) can0 124#11\n");
  ASSERT_EQ(outcome.records.size(), 2u);
  EXPECT_EQ(outcome.records[1].frame.id, 0x124u);
  EXPECT_THAT(outcome.where, ElementsAre(2));
}

TEST(CandumpLogFile, ALineThatNeverEndsIsGivenUp) {
  const std::string endless(70'000, '1');
  const Outcome outcome = read_capture("(1.0) can0 123#00\n" + endless + "\n(2.0) can0 124#22\n");
  EXPECT_EQ(outcome.records.size(), 2u);
  EXPECT_EQ(outcome.damaged, 1u);
  EXPECT_EQ(outcome.bytes_skipped, 70'001u);
}

TEST(CandumpScreenFile, TimeAndFlagsMayBeMissing) {
  EXPECT_THAT(data_of(only("  can0  123   [3]  11 22 33\n")), ElementsAre(0x11, 0x22, 0x33));
  EXPECT_EQ(only(" (000.001500)  can0  123   [0] \n").time, 1500us);
  const Seen fast = only("  vcan1  TX B E  12345678  [01]  FF   '.'\n");
  EXPECT_TRUE(fast.frame.fd && fast.frame.bit_rate_switch && fast.frame.extended);
  EXPECT_EQ(fast.interface, "vcan1");
  EXPECT_FALSE(fast.time);
}

TEST(TrcFile, LinesOfCantoolsTestsForVersion12) {
  const Outcome outcome = read_capture(
      ";$FILEVERSION=1.2\n;$STARTTIME=39878.6772258947;\n"
      "1) 1059.900 1 Rx 0300 7 00 00 00 00 04 00 00\n"
      "5) 1346.834 1 Warng FFFFFFFF 4 00 00 00 04 BUSLIGHT\n"
      "6) 1349.222 1 Error 0008 4 00 19 08 08\n"
      "7) 1352.743 1 Rx 0100 3 RTR\n");
  ASSERT_EQ(outcome.records.size(), 3u);
  EXPECT_EQ(outcome.damaged, 0u);
  EXPECT_THAT(data_of(outcome.records[0]), ElementsAre(0, 0, 0, 0, 4, 0, 0));
  EXPECT_TRUE(outcome.records[1].frame.error);
  EXPECT_TRUE(outcome.records[2].frame.remote);
  EXPECT_EQ(outcome.records[2].frame.size, 3);
  EXPECT_EQ(outcome.records[2].time.value() - outcome.records[0].time.value(), 292843us);
}

TEST(TrcFile, AMessageLongerThanAFrameIsNone) {
  const Outcome outcome = read_capture(
      ";$FILEVERSION=1.3\n"
      "1) 1.000 1 Rx 10062123 - 9 D2 AF AA 88 18 80 01 02 03\n"
      "2) 2.000 1 Rx 0123 - 2 AA BB\n");
  ASSERT_EQ(outcome.records.size(), 1u);
  EXPECT_THAT(outcome.where, ElementsAre(2));
}

/// As editors on Windows and mail programs leave text files.
TEST(EveryTextFormat, TakesTheMarkOfUtf8AndBlanksAroundALine) {
  for (const std::string line :
       {"(1436509052.249713) vcan0 044#2A366C2BBA", "  vcan0  044   [5]  2A 36 6C 2B BA",
        "   0.249713 1  44              Rx   d 5 2A 36 6C 2B BA",
        "2022-09-28-11:36:59.668,5,130311,35,255,8,c5,c0,1c,6e,ff,7f,ff,ff"}) {
    const Outcome plain = read_capture(line + "\n" + line + "\n");
    const Outcome edited = read_capture("\xEF\xBB\xBF" + line + " \t\r\n \t" + line + "  ");
    ASSERT_EQ(plain.records.size(), 2U) << line;
    ASSERT_EQ(edited.records.size(), 2U) << line;
    EXPECT_THAT(edited.where, ElementsAre());
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_EQ(edited.records[i].frame, plain.records[i].frame) << line;
  }
}

/// PEAK's description of version 2: the type RR is a remote request, which has no data.
TEST(TrcFile, ARemoteRequestOfVersion2HasALengthAndNoData) {
  const Seen seen = only(
      ";$FILEVERSION=2.1\n;$COLUMNS=N,O,T,B,I,d,R,L,D\n"
      "  4  300.0 RR 1 0100 Rx - 3\n");
  EXPECT_TRUE(seen.frame.remote);
  EXPECT_EQ(seen.frame.size, 3);
}

TEST(CandumpFile, WordsMayHaveMoreThanOneBlankBetweenThem) {
  const Outcome outcome = read_capture("(1436509052.249713)  vcan0\t044#2A366C2BBA   T\n");
  ASSERT_EQ(outcome.records.size(), 1U);
  EXPECT_EQ(outcome.records[0].frame.id, 0x44U);
  EXPECT_EQ(outcome.records[0].frame.size, 5);
}

TEST(FilesWithTimesOfDay, GoOnOverMidnight) {
  const Outcome actisense = read_capture(
      "A235959.900 01FF6 0EE00 05A0BE1C00A0A0C0\nA000000.100 01FF6 0EE00 05A0BE1C00A0A0C0\n");
  const Outcome ydwg = read_capture(
      "23:59:59.900 R 18EEFF01 05 A0\n23:59:59.800 T 18EEFF01 05\n00:00:00.100 R 18EEFF01 05\n");
  ASSERT_EQ(actisense.records.size(), 2U);
  ASSERT_EQ(ydwg.records.size(), 3U);
  EXPECT_EQ(*actisense.records[1].time - *actisense.records[0].time, 200ms);
  EXPECT_EQ(ydwg.records[1].time, 24h - 200ms) << "a line out of its order";
  EXPECT_EQ(ydwg.records[2].time, 24h + 100ms);
}

/// A line of SavvyCAN's own making has a comma at its end, and microseconds since its start.
TEST(SavvyCanFile, TimesMayCountFromTheStart) {
  const Seen seen = only("185818721,00000545,false,Rx,1,4,00,04,7F,FF,\n");
  EXPECT_EQ(seen.time, 185'818'721us);
  EXPECT_EQ(seen.frame.id, 0x545U);
  EXPECT_EQ(seen.interface, "can1");
  EXPECT_THAT(data_of(seen), ElementsAre(0x00, 0x04, 0x7F, 0xFF));
}

/// RFC 4648, section 10: "foobar" in base64 is Zm9vYmFy, "fooba" Zm9vYmE=, "foob" Zm9vYg==.
TEST(PythonCanFile, DataAreInBase64) {
  EXPECT_THAT(data_of(only("1.5,0x1,0,0,0,6,Zm9vYmFy\n")),
              ElementsAre('f', 'o', 'o', 'b', 'a', 'r'));
  EXPECT_THAT(data_of(only("1.5,0x1,0,0,0,5,Zm9vYmE=\n")), ElementsAre('f', 'o', 'o', 'b', 'a'));
  EXPECT_THAT(data_of(only("1.5,0x1,0,0,0,4,Zm9vYg==\n")), ElementsAre('f', 'o', 'o', 'b'));
  const Outcome outcome =
      read_capture("1.5,0x1,0,0,0,4,Zm9vYg==\n1.5,0x1,0,0,0,5,Zm9vYg==\n1.5,0x1,0,0,0,3,Zm9*\n");
  EXPECT_EQ(outcome.records.size(), 1U);
  EXPECT_EQ(outcome.damaged, 2U);
}

}  // namespace formats_test
}  // namespace drydock::capture::testing
