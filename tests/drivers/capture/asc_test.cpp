#include <gmock/gmock.h>

#include "tests/drivers/capture/captures.hpp"

/// Rare lines of Vector's ASC files, and the time of their start.
namespace drydock::capture::testing {
namespace asc_test {

using ::testing::ElementsAre;
using namespace std::chrono_literals;

constexpr const char* asc_head = "base hex  timestamps absolute\n";

TEST(AscFile, LinesOfPythonCansTests) {
  const Seen remote = only(asc_head + std::string("  30.300981 CANFD   3 Tx     50005x             "
                                                  "                   0 1 5 0 140000 73 200050 "
                                                  "7a60 46500250 460a0250 20011736 20010205\n"));
  EXPECT_TRUE(remote.frame.remote && remote.frame.extended);
  EXPECT_EQ(remote.frame.id, 0x50005u);
  EXPECT_EQ(remote.frame.size, 5);
  EXPECT_EQ(remote.interface, "can2");
  const Seen named = only(
      asc_head +
      std::string(
          "   0.045746 CANFD   62 Rx        167x  VehicleOperatingModes            1 0 8  8 73 80 "
          "00 10 "
          "00 09 e3 00   102187  133   323000 e000fb6c 46500250 4b140250 20011736 2001040d\n"));
  EXPECT_TRUE(named.frame.fd && named.frame.bit_rate_switch && named.frame.extended);
  EXPECT_THAT(data_of(named), ElementsAre(0x73, 0x80, 0, 0x10, 0, 9, 0xE3, 0));
}

TEST(AscFile, StatisticsAndStatesAndTransportProtocolsAreNoFrames) {
  const Outcome outcome = read_capture(
      asc_head +
      std::string("internal events logged\n// version 9.0.0\n   0.000000 Start of measurement\n"
                  "   0.015991 CAN 1 Status:chip status error passive - TxErr: 132 RxErr: 0\n"
                  "   1.015991 1  Statistic: D 0 R 0 XD 0 XR 0 E 0 O 0 B 0.00%\n"
                  "   3.297743 1  J1939TP FEE3p        6    0  0   -   Rx   d 3 A0 0F A6\n"
                  "End TriggerBlock\n"));
  EXPECT_TRUE(outcome.records.empty());
  EXPECT_EQ(outcome.damaged, 0u);
}

// A line of can-utils' asc2log. A frame of CAN XL has no place in a CAN FD frame, so it is counted.
TEST(AscFile, AFrameOfCanXlIsCountedAsNotUnderstood) {
  const Outcome outcome = read_capture(
      asc_head + std::string("  59.171614 CANXL   2 Rx   XLFF   984438   4656      432  msg e0 0 "
                             "1fe  511 1 1f96 00 00000000 e1 89 e8 c2\n"));
  EXPECT_TRUE(outcome.records.empty());
  EXPECT_EQ(outcome.damaged, 1u);
}

TEST(AscFile, TheDateOfItsHeadIsTheTimeOfItsStart) {
  const std::string line = "   1.500000 1  123x            Rx   d 1 68\n";
  const auto time = [&](const std::string& date) {
    return only("date " + date + "\n" + line).time;
  };
  EXPECT_EQ(time("Sat Sep 30 15:06:13.191 2017"), 1506783973191ms + 1500ms);  // date -u -d ... +%s
  EXPECT_EQ(time("Sam Sep 30 15:06:13.191 2017"), 1506783973191ms + 1500ms);
  EXPECT_EQ(time("Sat Sep 30 03:06:13.191 pm 2017"), 1506783973191ms + 1500ms);
  EXPECT_EQ(time("Mon Dez 1 12:00:00 am 2025"), 1764547200000ms + 1500ms);
  EXPECT_EQ(time("Mandag 1 desember"), 1500ms);
}

/// python-can writes the time of the conversion into the head, and that of the data into the block;
/// its own ASCReader gives 1700000000.0.
TEST(AscFile, ATriggerBlockBeforeTheDateOfItsHeadIsTheStart) {
  const auto time = [&](const std::string& head, const std::string& block) {
    return only(head + "base hex  timestamps absolute\nBegin Triggerblock " + block +
                "\n   1.500000 1  123x            Rx   d 1 68\n")
        .time;
  };
  const std::string head = "date Thu Nov 26 10:09:56.678 PM 2026\n";
  EXPECT_EQ(time(head, "Tue Nov 14 10:13:20.000 PM 2023"), 1700000000s + 1500ms);
  EXPECT_EQ(time("", "Tue Nov 14 10:13:20.000 PM 2023"), 1700000000s + 1500ms);
  const auto of_head = 1795730996678ms + 1500ms;
  EXPECT_EQ(time(head, "Thu Nov 26 10:10:06.000 PM 2026"), of_head) << "a trigger comes later";
  EXPECT_EQ(time(head, "Thu Nov 26 10:09:56 PM 2026"), of_head) << "rounded down to its second";
}

TEST(AscFile, TheBaseCountsInAnyLetters) {
  const Seen seen = only("Base Dec  Timestamps Absolute\n 0.1 1 217056256x RX d 2 10 255\n");
  EXPECT_EQ(seen.frame.id, 217056256U);
  EXPECT_THAT(data_of(seen), ElementsAre(10, 255));
}

}  // namespace asc_test
}  // namespace drydock::capture::testing
