#include "drivers/device/gnss/ublox_setup.hpp"

#include <gmock/gmock.h>

#include "drivers/device/gnss/gnss_driver.hpp"
#include "drivers/wire/ubx/ubx_put.hpp"
#include "tests/drivers/device/support.hpp"

/// Both sides of the dialogue are written by hand from UBX-13003221: payloads of CFG-PRT (20 bytes,
/// the port first), CFG-RATE (period in ms, cycles, time reference) and CFG-MSG (class, id, a rate
/// for each of six ports).
namespace drydock::device::test {
namespace ublox_setup_test {

using namespace std::chrono_literals;
namespace ubx = wire::ubx;
using testing::ElementsAre;

constexpr std::uint16_t nav_pvt = 0x0107, gga = 0xF000;

class UbloxDialogue : public testing::Test {
 protected:
  void start(const UbloxSettings& wanted) {
    setup_.emplace(wanted);
    setup_->start(now_, ear_);
  }

  /// The last frame that was sent.
  Octets asked() const { return ear_.sent_bytes.empty() ? Octets{} : ear_.sent_bytes.back(); }
  static Octets frame(std::uint16_t id, const Octets& payload) {
    Octets bytes(payload.size() + ubx::overhead);
    ubx::encode_frame(id, payload, bytes);
    return bytes;
  }

  void say(std::uint16_t id, const Octets& payload) {
    setup_->receive(frame(id, payload), now_, ear_);
  }
  void acknowledge(std::uint16_t id, std::uint16_t verdict = ubx::ack_ack) {
    say(verdict, {static_cast<std::uint8_t>(id >> 8), static_cast<std::uint8_t>(id)});
  }
  void say_port(std::uint8_t port) {
    Octets payload(20);
    payload[0] = port;
    say(ubx::cfg_prt, payload);
    acknowledge(ubx::cfg_prt);
  }
  void say_period(std::uint8_t low, std::uint8_t high) {
    say(ubx::cfg_rate, {low, high, 1, 0, 0, 0});
    acknowledge(ubx::cfg_rate);
  }
  void say_rates(std::uint16_t id, std::array<std::uint8_t, 6> rates) {
    Octets payload{static_cast<std::uint8_t>(id >> 8), static_cast<std::uint8_t>(id)};
    payload.insert(payload.end(), rates.begin(), rates.end());
    say(ubx::cfg_msg, payload);
    acknowledge(ubx::cfg_msg);
  }
  void wait_for_deadline() {
    ASSERT_TRUE(setup_->deadline());
    now_ = *setup_->deadline();
    setup_->tick(now_, ear_);
  }

  Ear ear_;
  Stamp now_ = at_s(1);
  std::optional<UbloxSetup> setup_;
};

const UbloxSettings five_hertz{.period = 200ms, .messages = {}};
const UbloxSettings pvt_alone{.period = {}, .messages = {{nav_pvt, 1}, {gga, 0}}};

TEST_F(UbloxDialogue, ReadsThePeriodSetsItAndReadsItBackWithWhatElseItHad) {
  start(five_hertz);
  EXPECT_EQ(asked(), frame(ubx::cfg_rate, {}));
  say_period(0xE8, 0x03);  // 1000 ms, 1 cycle, UTC
  EXPECT_EQ(asked(), frame(ubx::cfg_rate, {0xC8, 0, 1, 0, 0, 0}));
  acknowledge(ubx::cfg_rate);
  EXPECT_EQ(asked(), frame(ubx::cfg_rate, {}));
  say_period(0xC8, 0);
  EXPECT_TRUE(setup_->finished());
  EXPECT_EQ(setup_->deadline(), std::nullopt);
  EXPECT_TRUE(ear_.reports.empty());
}

TEST_F(UbloxDialogue, SetsNothingThatAlreadyHolds) {
  start(five_hertz);
  say_period(0xC8, 0);
  EXPECT_TRUE(setup_->finished());
  EXPECT_EQ(ear_.sent_bytes.size(), 1U);
}

TEST_F(UbloxDialogue, ComparesTheRateOfThePortThatItIsAt) {
  start(pvt_alone);
  EXPECT_EQ(asked(), frame(ubx::cfg_prt, {}));
  say_port(3);  // USB
  EXPECT_EQ(asked(), frame(ubx::cfg_msg, {0x01, 0x07}));
  say_rates(nav_pvt, {0, 1, 1, 0, 0, 0});
  EXPECT_EQ(asked(), frame(ubx::cfg_msg, {0x01, 0x07, 1}));
  acknowledge(ubx::cfg_msg);
  say_rates(nav_pvt, {0, 1, 1, 1, 0, 0});
  EXPECT_EQ(asked(), frame(ubx::cfg_msg, {0xF0, 0x00}));
  say_rates(gga, {1, 1, 1, 0, 1, 0});
  EXPECT_TRUE(setup_->finished());
  EXPECT_TRUE(ear_.reports.empty());
}

TEST_F(UbloxDialogue, SaysWhatIsRefusedAndGoesOnWithTheNext) {
  start(pvt_alone);
  say_port(1);
  acknowledge(ubx::cfg_msg, ubx::ack_nak);
  EXPECT_EQ(asked(), frame(ubx::cfg_msg, {0xF0, 0x00}));
  say_rates(gga, {1, 1, 1, 1, 1, 0});
  acknowledge(ubx::cfg_msg, ubx::ack_nak);
  EXPECT_TRUE(setup_->finished());
  EXPECT_THAT(ear_.reports, ElementsAre("the receiver refuses CFG-MSG of NAV-PVT",
                                        "the receiver refuses CFG-MSG of GGA"));
}

TEST_F(UbloxDialogue, SaysThatAValueDoesNotHold) {
  start(five_hertz);
  say_period(0xE8, 0x03);
  acknowledge(ubx::cfg_rate);
  say_period(0xFA, 0);
  EXPECT_TRUE(setup_->finished());
  EXPECT_THAT(ear_.reports, ElementsAre("the receiver keeps another value after CFG-RATE"));
}

TEST_F(UbloxDialogue, AsksASilentReceiverThreeTimesAndAgainAfterHalfAMinute) {
  start(five_hertz);
  for (int tries = 0; tries < 3; ++tries) wait_for_deadline();
  EXPECT_EQ(ear_.sent_bytes.size(), 3U);
  EXPECT_THAT(ear_.reports, ElementsAre("no answer to CFG-RATE"));
  EXPECT_EQ(setup_->deadline(), now_ + 30s);
  wait_for_deadline();
  EXPECT_EQ(ear_.sent_bytes.size(), 4U);
}

TEST_F(UbloxDialogue, HeedsNoAnswerToAnotherQuestion) {
  start(five_hertz);
  acknowledge(ubx::cfg_msg);
  say(ubx::cfg_rate, {0xC8, 0});  // too short
  acknowledge(ubx::cfg_rate);
  say(0x0107, Octets(92));
  EXPECT_FALSE(setup_->finished());
  EXPECT_EQ(ear_.sent_bytes.size(), 1U);
}

TEST_F(UbloxDialogue, WithoutSettingsSaysNothing) {
  start({});
  EXPECT_TRUE(ear_.sent_bytes.empty());
  EXPECT_TRUE(setup_->finished());
}

TEST_F(UbloxDialogue, ExpectsNoAnswerOfARecording) {
  setup_.emplace(five_hertz);
  setup_->expect_no_answers(true);
  setup_->start(now_, ear_);
  for (int tries = 0; tries < 3; ++tries) wait_for_deadline();
  EXPECT_TRUE(ear_.reports.empty());
}

TEST(GnssDriver, SetsUpAReceiverAtEachOpeningOfItsLinkAndReadsPositionsMeanwhile) {
  DriverOptions options;
  options.kind = Kind::gnss;
  options.protocol = "ubx";
  options.ublox = five_hertz;
  GnssDriver driver(options);
  Ear ear;
  driver.restart(at_s(1), ear);
  ASSERT_EQ(ear.sent_bytes.size(), 1U);
  EXPECT_EQ(ear.sent_bytes[0], test::ubx(0x06, 0x08, {}));
  EXPECT_EQ(driver.deadline(), at_s(2));
  driver.receive(test::ubx(0x06, 0x08, {0xC8, 0, 1, 0, 1, 0}), at_s(1.1), ear);
  driver.receive(test::ubx(0x05, 0x01, {0x06, 0x08}), at_s(1.2), ear);
  EXPECT_EQ(driver.deadline(), std::nullopt);
  driver.restart(at_s(9), ear);
  EXPECT_EQ(ear.sent_bytes.size(), 2U);
}

/// A receiver that is set up at 1 s, then goes on as the test says.
class PoweredUblox : public testing::Test {
 protected:
  void open(const UbloxSettings& wanted) {
    DriverOptions options;
    options.kind = Kind::gnss;
    options.protocol = "ubx+nmea0183";
    options.ublox = wanted;
    driver_ = byte_driver(options);
    driver_->restart(now_, ear_);
  }
  void hear(const Octets& bytes, std::chrono::milliseconds after) {
    now_ += after;
    while (driver_->deadline() && *driver_->deadline() <= now_)
      driver_->tick(*driver_->deadline(), ear_);
    driver_->receive(bytes, now_, ear_);
  }
  void sends_for(std::chrono::seconds time, const Octets& bytes, std::chrono::milliseconds each) {
    for (auto t = 0ms; t < time; t += each) hear(bytes, each);
  }
  /// Plays the receiver: at the factory's rates until it is set.
  void answer_all() {
    for (; answered_ < ear_.sent_bytes.size(); ++answered_) {
      const Octets asked = ear_.sent_bytes[answered_];
      const Octets payload(asked.begin() + 6, asked.end() - 2);
      const Octets acknowledged = test::ubx(0x05, 0x01, {asked[2], asked[3]});
      Octets answer;
      if (asked[3] == 0x00)
        answer =
            test::ubx(0x06, 0x00, {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
      if (asked[3] == 0x01) {
        auto& rate = payload[0] == 0xF0 ? gga_ : pvt_;
        if (payload.size() == 3)
          rate = payload[2];
        else
          answer = test::ubx(0x06, 0x01, {payload[0], payload[1], 0, rate, 0, 0, 0, 0});
      }
      hear(answer + acknowledged, 5ms);
    }
  }
  void lose_power() { pvt_ = 0, gga_ = 1; }

  Ear ear_;
  Stamp now_ = at_s(1);
  std::unique_ptr<ByteDriver> driver_;
  std::size_t answered_ = 0;
  std::uint8_t pvt_ = 0, gga_ = 1;
};

const Octets a_pvt = test::ubx(0x01, 0x07, Octets(92));
const Octets a_gga = nmea("GPGGA,120000.00,4130.0000,N,07042.0000,W,1,12,0.8,57.0,M,-45.0,M,,");

TEST_F(PoweredUblox, IsSetUpAgainAfterASilence) {
  open(pvt_alone);
  answer_all();
  ASSERT_EQ(pvt_, 1);
  sends_for(10s, a_pvt, 200ms);
  lose_power();
  hear(a_gga, 4s);
  answer_all();
  EXPECT_EQ(pvt_, 1);
  EXPECT_EQ(gga_, 0);
  EXPECT_TRUE(ear_.reports.empty());
}

TEST_F(PoweredUblox, IsSetUpAgainAfterAShortBootWhenWhatWasSwitchedOffComes) {
  open(pvt_alone);
  answer_all();
  sends_for(10s, a_pvt, 200ms);
  lose_power();
  hear(a_gga, 1100ms);
  answer_all();
  EXPECT_EQ(pvt_, 1);
  EXPECT_EQ(gga_, 0);
}

TEST_F(PoweredUblox, IsSetUpAgainWhenOnlyOtherMessagesCome) {
  open({.period = {}, .messages = {{nav_pvt, 1}}});
  answer_all();
  sends_for(10s, a_pvt, 1000ms);
  lose_power();
  sends_for(7s, a_gga, 1000ms);
  answer_all();
  EXPECT_EQ(pvt_, 1);
}

TEST_F(PoweredUblox, IsNotAskedAllTheTimeWhenAnotherReceiverIsOnTheLine) {
  open(pvt_alone);
  answer_all();
  for (int minute = 0; minute < 5; ++minute) {
    const auto asked = ear_.sent_bytes.size();
    for (int s = 0; s < 60; ++s) hear(a_pvt, 500ms), hear(a_gga, 500ms), answer_all();
    EXPECT_LE(ear_.sent_bytes.size() - asked, 3U) << "the port and two messages, read once";
  }
}

TEST_F(PoweredUblox, WithItsSettingsIsAskedNothing) {
  open(pvt_alone);
  answer_all();
  const auto asked = ear_.sent_bytes.size();
  sends_for(300s, a_pvt, 1000ms);
  EXPECT_EQ(ear_.sent_bytes.size(), asked);
}

}  // namespace ublox_setup_test
}  // namespace drydock::device::test
