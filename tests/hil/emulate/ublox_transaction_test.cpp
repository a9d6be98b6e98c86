#include <gmock/gmock.h>

#include "tests/hil/emulate/ublox_host.hpp"

/// CFG-VALSET, VALDEL and VALGET of an F9: UBX-18010854.
namespace drydock::emulate {
namespace ublox_transaction_test {

using Frame = std::vector<std::uint8_t>;
namespace ubx = wire::ubx;
constexpr std::uint32_t rate_meas = 0x30210001, dynamic_model = 0x20110021;
constexpr std::uint8_t ram = 1, backed = 2, flash = 4;
enum Action : std::uint8_t { alone, start, ongoing, apply };

void add_key(Frame& frame, std::uint32_t key) {
  for (unsigned i = 0; i < 4; ++i) frame.push_back(static_cast<std::uint8_t>(key >> 8 * i));
}

struct F9 : UbloxHost {
  F9() : UbloxHost(rig_config::UbloxModel::f9) {}

  bool set_period(std::uint8_t action, std::uint16_t ms, std::uint8_t layers = ram) {
    Frame frame{1, layers, action, 0};
    add_key(frame, rate_meas);
    frame.insert(frame.end(), {static_cast<std::uint8_t>(ms), static_cast<std::uint8_t>(ms >> 8)});
    return acknowledges(ubx::cfg_valset, frame);
  }
  bool set_model(std::uint8_t action, std::uint8_t model) {
    Frame frame{1, ram, action, 0};
    add_key(frame, dynamic_model);
    frame.push_back(model);
    return acknowledges(ubx::cfg_valset, frame);
  }
  bool forget_period(std::uint8_t version, std::uint8_t layers, std::uint8_t action = alone) {
    Frame frame{version, layers, action, 0};
    add_key(frame, rate_meas);
    return acknowledges(ubx::cfg_valdel, frame);
  }
  /// The number of ms in a layer (0 RAM, 1 battery-backed, 2 flash); -1: ACK-NAK.
  int period(std::uint8_t layer = 0) {
    Frame frame{0, layer, 0, 0};
    add_key(frame, rate_meas);
    const auto answers = say(ubx::cfg_valget, frame);
    if (answers.size() < 2) return -1;
    const auto payload = ubx::packet_of(answers[0]).payload;
    return payload[8] | payload[9] << 8;
  }
  std::size_t epochs_in_4_s() {
    listen(4);
    return count(0x0107);
  }
};

TEST(UbloxTransaction, NothingTakesEffectBeforeItsLastMessage) {
  F9 f9;
  EXPECT_TRUE(f9.set_period(start, 200));
  EXPECT_LE(f9.epochs_in_4_s(), 5u);
  EXPECT_TRUE(f9.set_model(ongoing, 4));
  EXPECT_LE(f9.epochs_in_4_s(), 5u);
  EXPECT_TRUE(f9.acknowledges(ubx::cfg_valset, {1, ram, apply, 0}));
  EXPECT_GE(f9.epochs_in_4_s(), 20u);
  EXPECT_EQ(f9.period(), 200);
  EXPECT_FALSE(f9.set_period(ongoing, 500)) << "it has ended";
}

TEST(UbloxTransaction, AnInvalidTransitionIsRefusedAndCancels) {
  F9 f9;
  EXPECT_FALSE(f9.set_period(ongoing, 500));
  EXPECT_FALSE(f9.set_period(apply, 500));
  EXPECT_FALSE(f9.set_period(7, 500));
  const auto refused_in_it = [&](auto&& what) {
    EXPECT_TRUE(f9.set_period(start, 500));
    EXPECT_FALSE(what());
    EXPECT_FALSE(f9.acknowledges(ubx::cfg_valset, {1, ram, apply, 0})) << "it was cancelled";
    EXPECT_EQ(f9.period(), 1000);
  };
  refused_in_it([&] { return f9.set_period(7, 250); });
  refused_in_it([&] { return f9.set_period(ongoing, 250, ram | flash); });
  refused_in_it([&] { return f9.forget_period(1, flash, ongoing); });
  refused_in_it([&] { return f9.acknowledges(ubx::cfg_valset, {1, ram, ongoing, 0, 9, 9, 9, 9}); });
}

TEST(UbloxTransaction, AnyOtherSettingCancelsIt) {
  F9 f9;
  EXPECT_TRUE(f9.set_period(start, 500));
  EXPECT_EQ(f9.period(), 1000);  // CFG-VALGET
  EXPECT_FALSE(f9.set_period(apply, 500));
  EXPECT_TRUE(f9.set_period(start, 500));
  f9.say(ubx::cfg_rate);
  EXPECT_FALSE(f9.set_period(apply, 500));
  EXPECT_TRUE(f9.set_period(start, 500));
  EXPECT_TRUE(f9.forget_period(0, flash));
  EXPECT_FALSE(f9.set_period(apply, 500));
  EXPECT_EQ(f9.period(), 1000);
}

TEST(UbloxTransaction, AStartOrAMessageAloneForgetsWhatWaits) {
  F9 f9;
  EXPECT_TRUE(f9.set_period(start, 500));
  EXPECT_TRUE(f9.set_model(start, 4));
  EXPECT_TRUE(f9.acknowledges(ubx::cfg_valset, {1, ram, apply, 0}));
  EXPECT_EQ(f9.period(), 1000);
  EXPECT_TRUE(f9.set_period(start, 500));
  EXPECT_TRUE(f9.set_period(alone, 200));
  EXPECT_EQ(f9.period(), 200);
  EXPECT_FALSE(f9.set_period(apply, 500));
}

TEST(UbloxTransaction, ADeletionWaitsForItsEndToo) {
  F9 f9;
  EXPECT_TRUE(f9.set_period(alone, 250, flash));
  EXPECT_TRUE(f9.forget_period(1, flash, start));
  EXPECT_EQ(f9.period(2), 250) << "asking cancels the transaction";
  EXPECT_TRUE(f9.forget_period(1, flash, start));
  EXPECT_TRUE(f9.acknowledges(ubx::cfg_valdel, {1, flash, apply, 0}));
  EXPECT_EQ(f9.period(2), -1);
}

TEST(UbloxTransaction, ADeletionNeedsALayerThatKeeps) {
  F9 f9;
  EXPECT_FALSE(f9.forget_period(0, 0));
  EXPECT_FALSE(f9.forget_period(0, ram));
  EXPECT_TRUE(f9.forget_period(0, backed));
  EXPECT_TRUE(f9.forget_period(0, flash));
}

// "The validity is checked only if the message requests to apply the configuration to the RAM
// layer." The shortest period of an F9 is 25 ms.
TEST(UbloxTransaction, OnlyValuesForRamAreChecked) {
  F9 f9;
  EXPECT_FALSE(f9.set_period(alone, 10));
  EXPECT_TRUE(f9.set_period(alone, 10, flash));
  EXPECT_EQ(f9.period(2), 10);
  EXPECT_TRUE(f9.set_period(start, 10)) << "it applies nothing yet";
  EXPECT_FALSE(f9.acknowledges(ubx::cfg_valset, {1, ram, apply, 0}));
  f9.say(ubx::cfg_rst, {0, 0, 0, 0});
  EXPECT_EQ(f9.period(), 1000) << "after a reset what is not possible is passed over";
}

TEST(UbloxTransaction, ARefusedQuestionNamesItsKey) {
  F9 f9;
  Frame question{0, 0, 0, 0};
  add_key(question, 0x20999999);
  EXPECT_FALSE(f9.acknowledges(ubx::cfg_valget, question));
  EXPECT_EQ(f9.told.back(), "refused CFG-VALGET: unknown key 20999999h");
  EXPECT_EQ(f9.period(2), -1);
  EXPECT_EQ(f9.told.back(), "refused CFG-VALGET: key 30210001h: nothing in layer 2");
}

// 64 values in an answer; the field `position` skips those that were told.
TEST(UbloxTransaction, AWildcardOfAllGroupsAsksForEveryItem) {
  F9 f9;
  std::size_t answers = 0;
  bool has_baud = false, has_model = false;
  for (std::uint16_t skip = 0; skip < 1000; skip = static_cast<std::uint16_t>(skip + 64)) {
    Frame question{0, 0, static_cast<std::uint8_t>(skip), static_cast<std::uint8_t>(skip >> 8)};
    add_key(question, 0x0FFFFFFF);
    const auto said = f9.say(ubx::cfg_valget, question);
    if (said.size() < 2) break;
    ++answers;
    const auto payload = ubx::packet_of(said[0]).payload;
    for (std::size_t at = 4; at < payload.size();) {
      const auto key = wire::load_le<std::uint32_t>(payload, at);
      has_baud |= key == 0x40520001;
      has_model |= key == dynamic_model;
      constexpr std::array<std::size_t, 6> sizes{0, 1, 1, 2, 4, 8};
      at += 4 + sizes.at(key >> 28 & 7);
    }
  }
  EXPECT_GT(answers, 4u);
  EXPECT_TRUE(has_baud);
  EXPECT_TRUE(has_model);
}

// Byte 8 of the first block has the flags: the system is on, bit 16 is L1C/A, bit 20 L2C.
TEST(UbloxTransaction, TheSignalsOfCfgGnssAreThoseOfTheKeys) {
  F9 f9;
  const auto gps_flags = [&] {
    return wire::load_le<std::uint32_t>(ubx::packet_of(f9.say(ubx::cfg_gnss).at(0)).payload, 8);
  };
  EXPECT_EQ(gps_flags(), 0x00110001u);
  Frame no_l2{0, ram, 0, 0};
  add_key(no_l2, 0x10310003);
  no_l2.push_back(0);
  EXPECT_TRUE(f9.acknowledges(ubx::cfg_valset, no_l2));
  EXPECT_EQ(gps_flags(), 0x00010001u);
  EXPECT_TRUE(f9.acknowledges(ubx::cfg_gnss, {0, 60, 60, 1, 0, 8, 16, 0, 0x01, 0x00, 0x11, 0x01}));
  EXPECT_EQ(gps_flags(), 0x00110001u);
}

}  // namespace ublox_transaction_test
}  // namespace drydock::emulate
