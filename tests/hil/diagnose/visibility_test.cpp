#include "hil/diagnose/visibility.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace drydock::diagnose {
namespace visibility_test {

using diagnosis::Cause;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

rig_config::Rig rig_of(std::vector<std::pair<measurement::Kind, std::string>> devices) {
  rig_config::Rig rig;
  for (const auto& [kind, protocol] : devices) {
    auto& device = rig.devices.emplace_back();
    device.name = to_string(kind);
    device.kind = kind;
    device.protocol = protocol;
  }
  return rig;
}

const Circumstances minute{.duration_s = 100, .live = true, .has_times = true};

/// Why the cause could not have been seen on the device; empty: it could.
std::string why(const rig_config::Rig& rig, const std::string& device, Cause cause,
                const Circumstances& with = minute) {
  for (const Unseen& one : unseen_in(rig, with))
    if (std::ranges::find(one.devices, device) != one.devices.end() &&
        std::ranges::find(one.causes, cause) != one.causes.end())
      return one.why;
  return {};
}

TEST(Visibility, SilenceAndALostPortAreSeenOnEveryLiveDevice) {
  const auto rig = rig_of({{measurement::Kind::dvl, "pd0"}, {measurement::Kind::imu, "xsens"}});
  for (const char* device : {"dvl", "imu"}) {
    EXPECT_THAT(why(rig, device, Cause::silent), IsEmpty());
    EXPECT_THAT(why(rig, device, Cause::port_lost), IsEmpty());
  }
}

TEST(Visibility, DamageIsSeenOnlyThroughAChecksum) {
  const auto pd0 = rig_of({{measurement::Kind::dvl, "pd0"}});
  EXPECT_THAT(why(pd0, "dvl", Cause::damaged), IsEmpty());
}

/// docs/sensors/protocols/pd6.md: the sentences of PD6 have no checksum.
TEST(Visibility, DamageOfAProtocolWithoutAChecksumIsNot) {
  const auto pd6 = rig_of({{measurement::Kind::dvl, "pd6"}});
  EXPECT_EQ(why(pd6, "dvl", Cause::damaged), "its messages have no checksum");
}

TEST(Visibility, ACanDeviceIsNotSaidToHaveFaultsOfASerialLineAndTheOtherWayRound) {
  const auto rig = rig_of({{measurement::Kind::dvl, "pd0"}, {measurement::Kind::imu, "xsens"}});
  for (const Unseen& one : unseen_in(rig, minute)) {
    const Cause of_the_other = one.devices.front() == "imu" ? Cause::wrong_baud : Cause::bus_off;
    EXPECT_THAT(one.causes, Not(Contains(of_the_other))) << one.devices.front();
  }
}

TEST(Visibility, AFileHasNoPortAndACaptureOfBytesHasNoTimes) {
  const auto rig = rig_of({{measurement::Kind::dvl, "pd0"}});
  const Circumstances file{.duration_s = 100, .live = false, .has_times = true};
  const Circumstances bytes{.duration_s = 0, .live = false, .has_times = false};
  EXPECT_EQ(why(rig, "dvl", Cause::port_lost, file), "a file has no port");
  EXPECT_THAT(why(rig, "dvl", Cause::silent, file), IsEmpty());
  EXPECT_EQ(why(rig, "dvl", Cause::silent, bytes), "the capture has no times of arrival");
}

/// A reason is either that of the sensors or that this version does not look for it.
TEST(Visibility, ABiasIsSeenOnlyBesideASensorThatMeasuresTheSame) {
  const auto alone = rig_of({{measurement::Kind::dvl, "pd0"}});
  EXPECT_THAT(why(alone, "dvl", Cause::bias), Not(IsEmpty()));
  const auto with_log =
      rig_of({{measurement::Kind::dvl, "pd0"}, {measurement::Kind::emlog, "nmea0183"}});
  EXPECT_NE(why(with_log, "dvl", Cause::bias), "no other sensor measures what it does");
}

TEST(Visibility, AHiddenSkyIsTakenForADiveWhereNothingTellsTheDepth) {
  using measurement::Kind;
  const auto rig_with = [](Kind kind) { return rig_of({{Kind::gnss, "ubx"}, {kind, ""}}); };
  const auto unseen = HasSubstr("dive");
  EXPECT_THAT(why(rig_with(Kind::imu), "gnss", Cause::satellites_blocked), unseen);
  EXPECT_THAT(why(rig_with(Kind::depth), "gnss", Cause::satellites_blocked), IsEmpty());
  EXPECT_THAT(why(rig_with(Kind::dvl), "gnss", Cause::satellites_blocked), IsEmpty());
}

/// The rudder is checked against the turn, the shaft against the speed.
TEST(Visibility, ABiasOfARudderIsSeenBesideAnInertialUnit) {
  const auto rig =
      rig_of({{measurement::Kind::actuator, "nmea2000"}, {measurement::Kind::imu, "xsens"}});
  EXPECT_THAT(why(rig, "actuator", Cause::bias), IsEmpty());
}

/// A raster shows them: the earliest arrivals and one hole of it.
TEST(Visibility, AClockThatDriftsAndADelayAreSeenWithoutTheDevicesOwnTime) {
  const auto pd6 = rig_of({{measurement::Kind::dvl, "pd6"}});
  const auto pd4 = rig_of({{measurement::Kind::dvl, "pd4"}});
  for (const auto& rig : {pd6, pd4})
    for (const Cause cause : {Cause::clock_drift, Cause::delay})
      EXPECT_THAT(why(rig, "dvl", cause), IsEmpty());
  const auto log = rig_of({{measurement::Kind::emlog, "nmea0183"}});
  EXPECT_EQ(why(log, "emlog", Cause::clock_step), "its messages tell no time");
}

TEST(Visibility, AMountingIsSeenBesideADepthSensorOnly) {
  using measurement::Kind;
  const auto with_depth = rig_of({{Kind::dvl, "pd0"}, {Kind::depth, "cia404_depth"}});
  const auto with_log = rig_of({{Kind::dvl, "pd0"}, {Kind::emlog, "nmea0183"}});
  EXPECT_THAT(why(with_depth, "dvl", Cause::mounting), IsEmpty());
  EXPECT_THAT(why(with_log, "dvl", Cause::mounting), Not(IsEmpty()));
}

TEST(Visibility, AMountingIsSeenWhereTheHeadItselfTellsADepthThatChanges) {
  const auto rig = rig_of({{measurement::Kind::dvl, "pd0"}});
  const Circumstances with{.duration_s = 100, .has_times = false, .heads_with_depth = {"dvl"}};
  EXPECT_THAT(why(rig, "dvl", Cause::mounting, with), IsEmpty());
  EXPECT_THAT(why(rig, "dvl", Cause::scale, with), Not(IsEmpty()));
}

std::string hidden(const rig_config::Rig& rig, const std::string& device, Cause cause) {
  for (const Unseen& one : hidden_from_start(rig, minute))
    if (std::ranges::find(one.devices, device) != one.devices.end() &&
        std::ranges::find(one.causes, cause) != one.causes.end())
      return one.why;
  return {};
}

/// docs/pier/findings.md: monitors learn for 30 s (times) and 45 s (values), the checks for 25 s.
TEST(Visibility, WhatAFaultFromTheStartHidesIsNamedHoweverLongTheRunIs) {
  using measurement::Kind;
  const auto rig = rig_of({{Kind::dvl, "pd0"}, {Kind::emlog, "nmea0183"}});
  EXPECT_EQ(hidden(rig, "dvl", Cause::slow), "what is wrong in the first 30 s looks usual");
  EXPECT_EQ(hidden(rig, "dvl", Cause::noise), "what is wrong in the first 45 s looks usual");
  EXPECT_EQ(hidden(rig, "dvl", Cause::coarse), "what is wrong in the first 45 s looks usual");
  EXPECT_EQ(hidden(rig, "dvl", Cause::bias), "what is wrong in the first 25 s looks usual");
  EXPECT_THAT(hidden(rig, "dvl", Cause::damaged), IsEmpty()) << "a checksum needs no learning";
  EXPECT_THAT(hidden(rig, "emlog", Cause::clock_step), IsEmpty()) << "it is unseen at any time";
}

TEST(Visibility, WhatTheRigKnowsHidesNoFaultThatIsThereFromTheStart) {
  using measurement::Kind;
  const auto rig = rig_of({{Kind::dvl, "pd0"},
                           {Kind::emlog, "nmea0183"},
                           {Kind::gnss, "ubx"},
                           {Kind::depth, "keller"}});
  for (const Cause cause : {Cause::drop, Cause::jitter, Cause::bias}) {
    EXPECT_THAT(hidden(rig, "dvl", cause), IsEmpty()) << "its rate, and two other speeds";
    EXPECT_THAT(hidden(rig, "depth", cause), IsEmpty()) << "its rate, and a fix";
  }
  const auto of_capture =
      hidden_from_start(rig, {.duration_s = 100, .has_times = true, .rates_stated = false});
  EXPECT_TRUE(std::ranges::any_of(of_capture, [](const Unseen& one) {
    return std::ranges::find(one.causes, Cause::drop) != one.causes.end();
  })) << "nobody stated a rate";
}

/// docs/pier/findings.md: monitors learn for 30 s (times) and 45 s (values). 46 s leave a second.
TEST(Visibility, WhatMonitorsWereStillLearningIsNamed) {
  const auto rig = rig_of({{measurement::Kind::dvl, "pd0"}});
  const auto in = [&](double s, Cause cause) {
    return why(rig, "dvl", cause, {.duration_s = s, .live = true, .has_times = true});
  };
  for (const auto cause : {Cause::stuck, Cause::noise, Cause::spike, Cause::bottom_lost})
    EXPECT_EQ(in(46, cause), "the first 45 s of 46 s teach what is usual");
  EXPECT_EQ(in(46, Cause::drop), "the first 30 s of 46 s teach what is usual");
  EXPECT_EQ(in(20, Cause::slow), "20 s are too short to learn what is usual");
  EXPECT_EQ(in(30, Cause::clock_drift), "30 s are too short to learn what is usual");
  for (const auto cause : {Cause::silent, Cause::damaged, Cause::port_lost})
    EXPECT_THAT(in(5, cause), IsEmpty());
  for (const auto cause : {Cause::stuck, Cause::drop, Cause::delay})
    EXPECT_THAT(in(100, cause), IsEmpty());
}

TEST(Visibility, EveryCauseIsConcludedFromSomeSigns) {
  for (const auto& facts : diagnosis::causes())
    EXPECT_TRUE(is_concluded(facts.cause)) << facts.name;
}

TEST(Visibility, DevicesThatHaveTheSameReasonShareALine) {
  auto rig = rig_of({{measurement::Kind::dvl, "pd0"}, {measurement::Kind::dvl, "pd0"}});
  rig.devices[1].name = "dvl2";
  for (const Unseen& one : unseen_in(rig, minute))
    EXPECT_THAT(one.devices, testing::ElementsAre("dvl", "dvl2")) << one.why;
}

TEST(Visibility, WhatNoMonitorConcludesIsNamedForEveryDeviceThatCanHaveIt) {
  const auto rig = rig_of({{measurement::Kind::dvl, "pd0"}});
  EXPECT_TRUE(is_concluded(Cause::silent));
  EXPECT_TRUE(is_concluded(Cause::damaged));
  for (const auto cause : {Cause::stuck, Cause::noise, Cause::spike, Cause::duplicate})
    EXPECT_EQ(why(rig, "dvl", cause).empty(), is_concluded(cause));
}

}  // namespace visibility_test
}  // namespace drydock::diagnose
