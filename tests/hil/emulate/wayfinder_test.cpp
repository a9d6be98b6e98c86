#include "drivers/wire/dvl/wayfinder.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "drivers/wire/bytes.hpp"
#include "hil/emulate/dvl/wayfinder_dialogue.hpp"
#include "tests/hil/emulate/bench.hpp"

/// Offsets and numbers of commands are those of the maker's example programs.
namespace drydock::emulate {
namespace wayfinder_test {

using rig_config::DeviceKind;
using Bytes = std::vector<std::uint8_t>;
using namespace std::chrono_literals;

constexpr std::uint32_t stop = 0x0F, go = 0x10, trigger = 0x11, defaults = 0x17;
constexpr std::uint32_t get_time = 0x1D000001, set_time = 0x1F000002, get_system = 0x81000001,
                        get_setup = 0x85000001, set_setup = 0x87000002, set_sound = 0x86000003;
constexpr std::uint8_t done = 1, unknown = 2, wrong = 3, not_done = 4, not_set = 5, pinging = 7;

float float_at(const Bytes& bytes, std::size_t offset) {
  return wire::load_le<float>(bytes, offset);
}

Bytes command(std::uint32_t number, const Bytes& parameters = {}) {
  Bytes bytes(4);
  wire::store_le<std::uint32_t>(bytes, 0, number);
  bytes.insert(bytes.end(), parameters.begin(), parameters.end());
  return bytes;
}

Bytes float_bytes(float value) {
  Bytes bytes(4);
  wire::store_le<float>(bytes, 0, value);
  return bytes;
}

/// id, version, size, trigger, baud, speed of sound, range.
Bytes setup(std::uint8_t software_trigger, std::uint8_t baud, float sound_mps, float range_m) {
  Bytes bytes{0x22, 0x10, 16, 0, 0, 0, software_trigger, baud};
  for (const float value : {sound_mps, range_m})
    for (const std::uint8_t b : float_bytes(value)) bytes.push_back(b);
  return bytes;
}

motion::Truth level() {
  motion::Truth truth = under_way();
  truth.body_to_ned.setIdentity();
  return truth;
}

TEST(EmulatedWayfinder, ThePacketHoldsTheTruthWhereTheMakersProgramsReadIt) {
  const Frozen trajectory(level());
  const auto sent = record(device(DeviceKind::dvl, "wayfinder"), trajectory, 0.2);
  ASSERT_EQ(sent.messages.size(), 1u);
  const Bytes& p = sent.messages[0].bytes;
  ASSERT_EQ(p.size(), 98u);
  EXPECT_EQ(wire::Wayfinder::scan(p), wire::Scan::frame(98));
  EXPECT_EQ(p[6], 5);
  const Bytes data(p.begin() + 9, p.end() - 2);
  EXPECT_EQ(wire::load_le<std::uint32_t>(data, 2), 87u);
  EXPECT_EQ(data[6], 76);
  EXPECT_EQ(Bytes(data.begin() + 12, data.begin() + 18), (Bytes{23, 11, 14, 22, 13, 20}));
  EXPECT_EQ(data[20], 1) << "X, Y, Z";
  EXPECT_NEAR(float_at(data, 21), 0.123, 1e-6) << "X to starboard";
  EXPECT_NEAR(float_at(data, 25), 2, 1e-6) << "Y to the bow";
  EXPECT_NEAR(float_at(data, 29), 0.045, 1e-6) << "Z up";
  for (std::size_t beam = 0; beam < 4; ++beam) EXPECT_NEAR(float_at(data, 37 + 4 * beam), 30, 1e-5);
  EXPECT_NEAR(float_at(data, 53), 30, 1e-5);
  unsigned sum = 0;
  for (std::size_t i = 0; i < 85; ++i) sum += data[i];
  EXPECT_EQ(wire::load_le<std::uint16_t>(data, 85), sum % 65536);
}

TEST(EmulatedWayfinder, ADvlThatTellsTheBedsMotionTurnsTheVelocityRound) {
  const Frozen trajectory(level());
  auto config = device(DeviceKind::dvl, "wayfinder");
  config.velocity_of_bed = true;
  const auto sent = record(config, trajectory, 0.2);
  EXPECT_NEAR(float_at(sent.messages.at(0).bytes, 9 + 25), -2, 1e-6);
}

TEST(EmulatedWayfinder, BeyondItsRangeEveryValueIsNotANumber) {
  motion::Truth truth = level();
  truth.bed_depth_m = 20 + 61;
  const Frozen trajectory(truth);
  const auto sent = record(device(DeviceKind::dvl, "wayfinder"), trajectory, 0.2);
  for (const std::size_t offset : {21U, 25U, 29U, 33U, 37U, 53U})
    EXPECT_TRUE(std::isnan(float_at(sent.messages.at(0).bytes, 9 + offset))) << offset;
}

class WayfinderDialogueTest : public testing::Test {
 protected:
  Bytes answer(const Bytes& said, bool refuses = false) {
    return dialogue_.answer(said, 1'700'000'000s, refuses);
  }
  std::uint8_t status(const Bytes& said, bool refuses = false) {
    return answer(said, refuses).at(4);
  }
  WayfinderDialogue dialogue_;
};

TEST_F(WayfinderDialogueTest, ItPingsUntilItIsStopped) {
  EXPECT_TRUE(dialogue_.pings());
  EXPECT_EQ(answer(command(stop)), (Bytes{0x0F, 0, 0, 0, done, 0}));
  EXPECT_FALSE(dialogue_.pings());
  EXPECT_EQ(status(command(go)), done);
  EXPECT_TRUE(dialogue_.pings());
}

TEST_F(WayfinderDialogueTest, TheSystemIsAWayfinderWithBeamsAt30Degrees) {
  const Bytes said = answer(command(get_system));
  ASSERT_EQ(said.size(), 6u + 135);
  EXPECT_EQ(said[6], 0x21);
  EXPECT_EQ(float_at(said, 6 + 27), 30.0F);
  EXPECT_EQ(said[6 + 133], 76);
}

/// The parameters are those of the maker's sample: 2020-03-27 09:20:46.
TEST_F(WayfinderDialogueTest, TheClockIsSetWhileItDoesNotPingAndReadBack) {
  const Bytes at{0x23, 0x10, 12, 0, 0, 0, 20, 3, 27, 9, 20, 46};
  EXPECT_EQ(status(command(set_time, at)), pinging);
  status(command(stop));
  EXPECT_EQ(status(command(set_time, at)), done);
  EXPECT_EQ(dialogue_.clock_offset(), 1'585'300'846s - 1'700'000'000s);
  const Bytes said = answer(command(get_time));
  EXPECT_EQ(Bytes(said.begin() + 6, said.end()), at);
  Bytes no_day = at;
  no_day[8] = 32;
  EXPECT_EQ(answer(command(set_time, no_day)), (Bytes{2, 0, 0, 0x1F, wrong, 5}));
}

TEST_F(WayfinderDialogueTest, TheSetupIsTakenWithinItsLimitsAndReadBack) {
  status(command(stop));
  EXPECT_EQ(status(command(set_setup, setup(1, 3, 1480, 25))), done);
  const Bytes said = answer(command(get_setup));
  EXPECT_EQ(Bytes(said.begin() + 6, said.end()), setup(1, 3, 1480, 25));
  EXPECT_EQ(answer(command(set_setup, setup(0, 5, 1480, 25))).at(5), 1) << "baud";
  EXPECT_EQ(answer(command(set_setup, setup(0, 7, 1399, 25))).at(5), 3) << "speed of sound";
  EXPECT_EQ(answer(command(set_setup, setup(0, 7, 1480, 61))).at(5), 4) << "range";
  EXPECT_EQ(dialogue_.setup().longest_range_m, 25.0F);
  EXPECT_EQ(status(command(defaults)), done);
  EXPECT_EQ(dialogue_.setup().longest_range_m, 60.0F);
}

TEST_F(WayfinderDialogueTest, TheSpeedOfSoundIsSetWhileItPings) {
  EXPECT_EQ(status(command(set_sound, float_bytes(1470))), done);
  EXPECT_EQ(dialogue_.setup().sound_speed_mps, 1470.0F);
  EXPECT_EQ(status(command(set_sound, float_bytes(1601))), wrong);
  EXPECT_EQ(status(command(set_sound)), wrong);
}

TEST_F(WayfinderDialogueTest, ATriggerCountsOnlyWithTheSoftwareTriggerSet) {
  EXPECT_EQ(status(command(trigger)), not_done);
  status(command(stop));
  status(command(set_setup, setup(1, 7, 1500, 60)));
  status(command(go));
  EXPECT_FALSE(dialogue_.take_trigger());
  EXPECT_EQ(status(command(trigger)), done);
  EXPECT_TRUE(dialogue_.take_trigger());
  EXPECT_FALSE(dialogue_.take_trigger());
}

TEST_F(WayfinderDialogueTest, WhatItDoesNotKnowIsSaid) {
  EXPECT_EQ(status(command(0x12345678)), unknown);
  EXPECT_EQ(status({}), unknown);
  EXPECT_EQ(status({1, 2}), unknown);
}

TEST_F(WayfinderDialogueTest, ADvlThatRefusesTellsItsSettingsAndKeepsThem) {
  EXPECT_EQ(status(command(stop), true), not_done);
  EXPECT_EQ(status(command(set_sound, float_bytes(1470)), true), not_set);
  EXPECT_EQ(status(command(get_setup), true), done);
  EXPECT_TRUE(dialogue_.pings());
}

RC_GTEST_PROP(EmulatedWayfinder, AnyParametersHaveAnAnswerAndKeepTheSetupWithinItsLimits, ()) {
  WayfinderDialogue dialogue;
  for (int i = 0; i < 20; ++i) {
    const auto number = *rc::gen::element(stop, go, trigger, defaults, get_time, set_time,
                                          get_system, get_setup, set_setup, set_sound);
    const auto said = dialogue.answer(
        command(number, *rc::gen::container<Bytes>(rc::gen::arbitrary<std::uint8_t>())),
        1'700'000'000s, false);
    RC_ASSERT(said.size() >= 6u);
    RC_ASSERT(wire::load_le<std::uint32_t>(said, 0) == number);
    RC_ASSERT(dialogue.setup().sound_speed_mps >= 1400 && dialogue.setup().sound_speed_mps <= 1600);
    RC_ASSERT(dialogue.setup().longest_range_m >= 1 && dialogue.setup().longest_range_m <= 60);
  }
}

/// Both packets are as the maker's programs send them: get system, then stop pinging.
TEST(EmulatedWayfinder, ObeysTheCommandsOfAHost) {
  const Frozen trajectory(level());
  const auto made =
      make_emulated_device(device(DeviceKind::dvl, "wayfinder", 5), trajectory, 1).value();
  Recorder recorder;
  const Bytes ask{0xAA, 0x10, 0x01, 0x0F, 0, 0x02, 0x03, 0x08, 0, 0x01, 0, 0, 0x81, 0x59, 0x01};
  made->receive(ask, recorder.now, recorder);
  ASSERT_EQ(recorder.messages.size(), 1u);
  const Bytes said = recorder.messages[0].bytes;
  EXPECT_EQ(wire::Wayfinder::scan(said), wire::Scan::frame(11 + 6 + 135));
  EXPECT_EQ(Bytes(said.begin() + 9, said.begin() + 15), (Bytes{1, 0, 0, 0x81, done, 0}));
  Bytes damaged = ask;
  damaged[3] = 0x8F;  // its length says 128 bytes more
  made->receive(damaged, recorder.now, recorder);
  recorder.now += std::chrono::seconds{1};
  const Bytes halt{0xAA, 0x10, 0x01, 0x0F, 0, 0x02, 0x03, 0x08, 0, 0x0F, 0, 0, 0, 0xE6, 0};
  made->receive(halt, recorder.now, recorder);
  recorder.messages.clear();
  recorder.run(*made, at_s(1));
  EXPECT_TRUE(recorder.messages.empty());
}

}  // namespace wayfinder_test
}  // namespace drydock::emulate
