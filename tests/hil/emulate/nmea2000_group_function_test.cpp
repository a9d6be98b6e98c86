#include <gmock/gmock.h>

#include "tests/hil/emulate/nmea2000_client.hpp"

/// Heartbeats (PGN 126993) and group functions (PGN 126208) of an emulated speed log. Layouts and
/// error codes: canboat's database of PGNs (PGN_ERROR_CODE, TRANSMISSION_INTERVAL,
/// PARAMETER_FIELD).
namespace drydock::emulate {
namespace nmea2000_group_function_test {

namespace j1939 = wire::j1939;
using testing::ElementsAre;
using testing::IsEmpty;

/// 60,000 ms is EA60h; the counter goes from 0 to 252.
TEST(Nmea2000GroupFunction, AHeartbeatComesEachMinuteWithItsCounter) {
  SpeedLog log;
  log.sent.run(*log.node, at_s(181));
  const auto beats = log.sent_of(heartbeat);
  ASSERT_EQ(beats.size(), 3u);
  for (std::size_t i = 0; i < beats.size(); ++i)
    EXPECT_THAT(beats[i], ElementsAre(0x60, 0xEA, i, 0xCC, 0xFF, 0xFF, 0xFF, 0xFF));
}

TEST(Nmea2000GroupFunction, TheIntervalOfTheHeartbeatIsObeyedFromOneToSixtySeconds) {
  SpeedLog log;
  log.tell(request(heartbeat, 1000));
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x11, 0xF0, 0x01, 0x00, 0)));
  log.sent.frames.clear();
  log.sent.run(*log.node, at_s(301.5));
  const auto beats = log.sent_of(heartbeat);
  ASSERT_EQ(beats.size(), 300u);
  EXPECT_EQ(wire::load_le<std::uint16_t>(beats[0], 0), 1000);
  EXPECT_EQ((beats[299][2] - beats[0][2] + 253) % 253, 299 % 253) << "252 is followed by 0";

  log.tell(request(heartbeat, 999));
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x11, 0xF0, 0x01, 0x20, 0))) << "too low";
  log.tell(request(heartbeat, 60001));
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x11, 0xF0, 0x01, 0x10, 0)));
  log.tell(request(heartbeat, default_interval));
  log.sent.frames.clear();
  log.sent.run(*log.node, at_s(361));
  EXPECT_THAT(log.sent_of(heartbeat), IsEmpty());
}

TEST(Nmea2000GroupFunction, ARequestBringsThePgnToAllToo) {
  SpeedLog log;
  for (const std::uint8_t destination : {log_address, j1939::global_address}) {
    log.tell(request(product, unchanged), destination);
    EXPECT_EQ(log.sent_of(product).size(), 1u);
    EXPECT_THAT(log.answers(), IsEmpty());
    log.tell(request(heartbeat, unchanged), destination);
    EXPECT_EQ(log.sent_of(heartbeat).size(), 1u);
  }
  log.tell(request(product, unchanged), 0x55);
  EXPECT_THAT(log.sent.frames, IsEmpty()) << "asked of another node";
}

/// 126720 is 1EF00h, 128259 is 1F503h, 126996 is 1F014h.
TEST(Nmea2000GroupFunction, WhatItCannotDoIsRefusedWithItsCode) {
  SpeedLog log;
  log.tell(request(126720, unchanged));
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x00, 0xEF, 0x01, 0x01, 0)));
  log.tell(request(128259, 100));
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x03, 0xF5, 0x01, 0x20, 0)))
      << "more often than it measures";
  auto paired = request(product, unchanged);
  paired[10] = 3;
  paired.insert(paired.end(), {1, 0x34, 0x08, 2, 0, 0, 8, 1});
  log.tell(paired);
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x14, 0xF0, 0x01, 0x00, 3, 0x30, 0xF0)))
      << "version 2100 and load 1 are its own, product 0 is not";
  log.tell({1, 0x14, 0xF0, 0x01, 0xF8, 1, 2, 0, 0});
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x14, 0xF0, 0x01, 0x04, 1, 0xF5)));
  log.tell({1, 0x00, 0xEF, 0x01, 0xF3, 1, 2, 0, 0});
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x00, 0xEF, 0x01, 0x11, 1, 0xF1)))
      << "PGN, priority 3 and parameter";
  log.tell({3, 0x14, 0xF0, 0x01, 1, 0, 1, 2});
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x14, 0xF0, 0x01, 0x06, 0)))
      << "read fields";
  log.tell({5, 0x14, 0xF0, 0x01, 1, 0, 1, 2});
  EXPECT_THAT(log.answers(), ElementsAre(ElementsAre(2, 0x14, 0xF0, 0x01, 0x06, 0)));
}

TEST(Nmea2000GroupFunction, AcknowledgementsShortOnesAndRefusalsToAllAreNotAnswered) {
  SpeedLog log;
  log.tell({2, 0x14, 0xF0, 0x01, 0, 0});
  EXPECT_THAT(log.sent.frames, IsEmpty());
  log.tell({0, 0x14, 0xF0});
  EXPECT_THAT(log.sent.frames, IsEmpty());
  log.tell({});
  EXPECT_THAT(log.sent.frames, IsEmpty());
  EXPECT_THAT(log.sent.told,
              ElementsAre("a group function (126208) that is too short, not obeyed",
                          "a group function (126208) that is too short, not obeyed"));
  log.tell({9, 0x14, 0xF0, 0x01});
  EXPECT_THAT(log.sent.frames, IsEmpty());
  EXPECT_EQ(log.sent.told.back(), "unknown group function 9, not obeyed");
  log.tell(request(126720, unchanged), j1939::global_address);
  EXPECT_THAT(log.sent.frames, IsEmpty());
}

}  // namespace nmea2000_group_function_test
}  // namespace drydock::emulate
