#include "drivers/device/dvl/water_linked_dialogue.hpp"

#include "tests/drivers/device/support.hpp"

/// Both sides of the dialogue are written by hand from Water Linked's description.
namespace drydock::device::test {
namespace water_linked_dialogue_test {

using namespace std::chrono_literals;
namespace wl = wire::water_linked;
using wl::Verdict;

class Dialogue : public testing::Test {
 protected:
  void start(const std::optional<WaterLinkedSettings>& wanted) {
    dialogue_.emplace(wanted);
    dialogue_->start(now_, ear_);
  }

  /// The last command that was sent, without checksum.
  std::string asked() const {
    if (ear_.sent_bytes.empty()) return "";
    const Octets& bytes = ear_.sent_bytes.back();
    const std::string line(bytes.begin(), bytes.end());
    return line.substr(0, line.find('*'));
  }

  void answer(const wire::WaterLinked::Message& message) {
    dialogue_->receive(message, now_, ear_);
  }
  void answer(Verdict verdict) { answer(wl::Answer{verdict}); }

  void wait_for_deadline() {
    ASSERT_TRUE(dialogue_->deadline());
    now_ = *dialogue_->deadline();
    dialogue_->tick(now_, ear_);
  }

  static wl::Configuration configuration(double sound_speed_mps, double rotation_deg) {
    wl::Configuration m;
    m.sound_speed_mps = sound_speed_mps;
    m.mounting_rotation_rad = rotation_deg * degree;
    m.acoustic_enabled = true;
    return m;
  }

  Ear ear_;
  Stamp now_ = at_s(1);
  std::optional<WaterLinkedDialogue> dialogue_;
};

const WaterLinkedSettings all_settings{1490.0, 45 * degree, false};

TEST_F(Dialogue, OneCommandAfterTheOtherUntilAllIsSetAndReadBack) {
  start(all_settings);
  EXPECT_EQ(asked(), "wcv");
  answer(wl::Version{2, 7, 0});
  EXPECT_EQ(asked(), "wcs,1490.00,45.00,,,,");
  answer(Verdict::done);
  EXPECT_EQ(asked(), "wcc");
  answer(configuration(1490, 45));
  EXPECT_EQ(asked(), "wcp,3");
  answer(Verdict::done);
  EXPECT_TRUE(dialogue_->finished());
  EXPECT_FALSE(dialogue_->deadline());
  EXPECT_EQ(ear_.sent_bytes.size(), 4U);
  EXPECT_TRUE(ear_.reports.empty());
}

TEST_F(Dialogue, CommandsEndAsTheDocumentSays) {
  start(WaterLinkedSettings{});
  EXPECT_EQ(ear_.sent_bytes.at(0), octets("wcv*fe\r\n"));
}

TEST_F(Dialogue, WithoutSettingsTheDriverOnlyListens) {
  start(std::nullopt);
  EXPECT_TRUE(ear_.sent_bytes.empty());
  EXPECT_FALSE(dialogue_->deadline());
}

TEST_F(Dialogue, WhatIsNotNamedIsNotSet) {
  start(WaterLinkedSettings{{}, {}, true});
  answer(wl::Version{2, 7, 0});
  EXPECT_EQ(asked(), "wcc");
  answer(configuration(1475, 0));
  EXPECT_EQ(asked(), "wcp,1");
  answer(Verdict::done);
  EXPECT_TRUE(ear_.reports.empty());
}

TEST_F(Dialogue, AnAnswerThatDoesNotComeIsAskedForAgain) {
  start(all_settings);
  const Stamp asked_at = now_;
  wait_for_deadline();
  EXPECT_EQ(now_ - asked_at, 1s);
  EXPECT_EQ(ear_.sent_bytes.size(), 2U);
  EXPECT_EQ(ear_.sent_bytes[0], ear_.sent_bytes[1]);
  answer(wl::Version{2, 7, 0});
  EXPECT_EQ(asked(), "wcs,1490.00,45.00,,,,");
  EXPECT_TRUE(ear_.reports.empty());
}

TEST_F(Dialogue, ASilentDvlIsReportedAndTriedAgainLater) {
  start(all_settings);
  for (int i = 0; i < 3; ++i) wait_for_deadline();
  EXPECT_EQ(ear_.sent_bytes.size(), 3U);
  EXPECT_EQ(ear_.reports, (std::vector<std::string>{"no answer to \"wcv\""}));
  EXPECT_TRUE(dialogue_->finished());
  const Stamp given_up = now_;
  wait_for_deadline();
  EXPECT_EQ(now_ - given_up, 30s);
  EXPECT_EQ(ear_.sent_bytes.size(), 4U);
  EXPECT_FALSE(dialogue_->finished());
}

TEST_F(Dialogue, ARefusalIsReportedAndTheRestGoesOn) {
  start(all_settings);
  answer(wl::Version{2, 7, 0});
  answer(Verdict::refused);
  EXPECT_EQ(ear_.reports, (std::vector<std::string>{"the DVL refuses \"wcs,1490.00,45.00,,,,\""}));
  EXPECT_EQ(asked(), "wcc");
}

TEST_F(Dialogue, ACommandThatArrivedDamagedIsSentAgainThreeTimesInAll) {
  start(all_settings);
  answer(Verdict::bad_checksum);
  answer(Verdict::not_understood);
  EXPECT_EQ(ear_.sent_bytes.size(), 3U);
  EXPECT_TRUE(ear_.reports.empty());
  answer(Verdict::not_understood);
  EXPECT_EQ(ear_.reports, (std::vector<std::string>{"the DVL does not understand \"wcv\""}));
  EXPECT_EQ(asked(), "wcs,1490.00,45.00,,,,");
}

TEST_F(Dialogue, AValueThatDoesNotHoldIsReported) {
  start(all_settings);
  answer(wl::Version{2, 7, 0});
  answer(Verdict::done);
  auto held = configuration(1500.5, 0);
  held.acoustic_enabled = false;
  answer(held);
  EXPECT_EQ(ear_.reports,
            (std::vector<std::string>{
                "the DVL uses a speed of sound of 1500.50 m/s, not the one of the rig file",
                "the DVL turns its velocities by 0.00 degrees, not by the mounting_rotation_deg of "
                "the rig file",
                "the DVL's acoustics are switched off",
                "the DVL refuses wcs: it says that it took it, and keeps other values"}));
}

TEST_F(Dialogue, ARefusalIsTheLastWordAlsoWhenTheValuesDiffer) {
  start(all_settings);
  answer(wl::Version{2, 7, 0});
  answer(Verdict::refused);
  answer(configuration(1500.5, 0));
  EXPECT_EQ(ear_.reports.back(), "the DVL refuses \"wcs,1490.00,45.00,,,,\"");
}

TEST_F(Dialogue, ARotationOfLongAgoIsNotedThoughNoneIsAskedFor) {
  start(WaterLinkedSettings{1490.0, {}, false});
  answer(wl::Version{2, 7, 0});
  EXPECT_EQ(asked(), "wcs,1490.00,,,,,");
  answer(Verdict::done);
  answer(configuration(1490, 90));
  EXPECT_EQ(ear_.reports.size(), 1U);
}

TEST_F(Dialogue, AnotherMajorVersionIsReported) {
  start(WaterLinkedSettings{});
  answer(wl::Version{3, 0, 0});
  EXPECT_EQ(ear_.reports.size(), 1U);
}

TEST_F(Dialogue, ReportsBetweenTheAnswersDoNotMatter) {
  start(all_settings);
  answer(wl::BottomVelocity{});
  answer(configuration(1, 2));
  answer(Verdict::done);
  EXPECT_EQ(asked(), "wcv");
  EXPECT_EQ(ear_.sent_bytes.size(), 1U);
}

TEST(WaterLinkedDriver, GoesThroughARecordingAsItWentWithoutComplainingOfMissingAnswers) {
  DriverOptions o = options(Kind::dvl, "water-linked");
  o.dvl.water_linked = WaterLinkedSettings{};
  Ear ear;
  const auto driver = byte_driver(o);
  driver->set_provenance(measurement::Provenance::replayed);
  driver->restart(at_s(1), ear);
  for (int i = 2; i < 6; ++i) driver->tick(at_s(i), ear);
  EXPECT_TRUE(ear.reports.empty());
}

TEST(WaterLinkedDriver, SetsTheDvlUpWhenTheLinkOpens) {
  DriverOptions o = options(Kind::dvl, "water-linked");
  o.dvl.water_linked = WaterLinkedSettings{};
  Ear ear;
  const auto driver = byte_driver(o);
  driver->restart(at_s(2), ear);
  EXPECT_EQ(ear.sent_bytes.size(), 1U);
  EXPECT_EQ(driver->deadline(), at_s(3));
  driver->receive(octets("wrv,2,7,0*f3\r\n"), at_s(2.1), ear);
  EXPECT_EQ(ear.sent_bytes.size(), 2U);
  driver->tick(at_s(3.2), ear);
  EXPECT_EQ(ear.sent_bytes.size(), 3U) << "wcc again";
}

}  // namespace water_linked_dialogue_test
}  // namespace drydock::device::test
