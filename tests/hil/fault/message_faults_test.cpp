// Faults of a wire on a stream of numbered messages: how many come, which ones, in which order.
#include "hil/fault/wire/message_faults.hpp"

#include <gmock/gmock.h>

#include "tests/hil/fault/faults.hpp"

namespace drydock::fault::test {
namespace message_faults_test {

using testing::ElementsAre;

Message numbered(std::uint32_t number) {
  return {0xAA, static_cast<std::uint8_t>(number >> 8), static_cast<std::uint8_t>(number)};
}

std::uint32_t number_of(const Message& message) { return message.at(1) * 256u + message.at(2); }

std::vector<Message> sent_under(const std::vector<FaultConfig>& faults, std::uint32_t count) {
  MessageFaults<Message> wire(1, "dvl", 9600);
  wire.set(in_force(faults));
  std::vector<Message> out;
  for (std::uint32_t i = 0; i < count; ++i)
    wire.pass(numbered(i), [&](const Message& message) { out.push_back(message); });
  return out;
}

TEST(MessageFaults, WithoutOneEveryMessageComesAsItWas) {
  const auto out = sent_under({}, 1000);
  ASSERT_EQ(out.size(), 1000u);
  for (std::uint32_t i = 0; i < out.size(); ++i) ASSERT_EQ(out[i], numbered(i));
}

TEST(MessageFaults, OfDroppedMessagesTheirShareIsMissing) {
  // Binomial: 10 000 x 0.2, standard deviation 40.
  EXPECT_NEAR(sent_under({fault_of(FaultKind::drop, 0.2, 0.2)}, 10'000).size(), 8000, 160);
}

TEST(MessageFaults, DuplicatedMessagesStandBesideEachOther) {
  const auto out = sent_under({fault_of(FaultKind::duplicate, 0.3, 0.3)}, 10'000);
  EXPECT_NEAR(out.size(), 13'000, 4 * 46);
  for (std::size_t i = 1; i < out.size(); ++i) {
    const auto step = number_of(out[i]) - number_of(out[i - 1]);
    ASSERT_LE(step, 1u);
  }
}

TEST(MessageFaults, ReorderedMessagesComeRightAfterTheirSuccessorAndNoneIsLost) {
  const auto out = sent_under({fault_of(FaultKind::reorder, 0.2, 0.2)}, 10'000);
  EXPECT_GE(out.size(), 9'999u) << "the last may still wait for its successor";
  std::size_t swapped = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto off = static_cast<int>(number_of(out[i])) - static_cast<int>(i);
    ASSERT_LE(std::abs(off), 1);
    swapped += off == 1;
  }
  EXPECT_NEAR(static_cast<double>(swapped), 10'000 * 0.2 / 1.2, 200);
}

TEST(MessageFaults, GarbageStandsBetweenMessagesThatAreSound) {
  FaultConfig garbage = fault_of(FaultKind::garbage, 7, 0.5);
  const auto out = sent_under({garbage}, 1000);
  std::uint32_t sound = 0, noise = 0;
  for (const Message& message : out) {
    if (message == numbered(sound)) {
      ++sound;
    } else {
      ASSERT_EQ(message.size(), 7u);
      ++noise;
    }
  }
  EXPECT_EQ(sound, 1000u);
  EXPECT_NEAR(noise, 500, 64);
}

TEST(MessageFaults, FlipsTruncationsAndBrokenSumsHitTheirShare) {
  for (const auto kind : {FaultKind::flip, FaultKind::truncate, FaultKind::bad_checksum}) {
    const auto out = sent_under({fault_of(kind, 0.25, 0.25)}, 4000);
    ASSERT_EQ(out.size(), 4000u);
    std::size_t damaged = 0;
    for (std::uint32_t i = 0; i < out.size(); ++i) damaged += out[i] != numbered(i);
    EXPECT_NEAR(static_cast<double>(damaged), 1000, 4 * 27.4) << rig_config::word_of(kind).name;
  }
}

TEST(MessageFaults, AHungDeviceSaysNothing) {
  EXPECT_THAT(sent_under({fault_of(FaultKind::hang)}, 100), ElementsAre());
}

TEST(MessageFaults, OneThatHasGoneLeavesNothingBehind) {
  MessageFaults<Message> wire(1, "dvl", 9600);
  std::vector<Message> out;
  const auto keep = [&](const Message& message) { out.push_back(message); };
  const std::vector<FaultConfig> all{fault_of(FaultKind::drop, 1), fault_of(FaultKind::flip, 1),
                                     fault_of(FaultKind::hang), fault_of(FaultKind::garbage, 9)};
  wire.set(in_force(all));
  wire.pass(numbered(1), keep);
  EXPECT_THAT(out, ElementsAre());
  wire.set({});
  wire.pass(numbered(2), keep);
  EXPECT_THAT(out, ElementsAre(numbered(2)));
}

TEST(MessageFaults, AnotherDeviceOrSeedIsHitAtOtherTimesTheSameOneAtTheSame) {
  const auto hits = [](std::uint64_t seed, const char* device) {
    const std::vector<FaultConfig> drop{fault_of(FaultKind::drop, 0.5, 0.5)};
    MessageFaults<Message> wire(seed, device);
    wire.set(in_force(drop));
    std::vector<std::uint32_t> come;
    for (std::uint32_t i = 0; i < 200; ++i)
      wire.pass(numbered(i), [&](const Message& message) { come.push_back(number_of(message)); });
    return come;
  };
  EXPECT_EQ(hits(1, "dvl"), hits(1, "dvl"));
  EXPECT_NE(hits(1, "dvl"), hits(2, "dvl"));
  EXPECT_NE(hits(1, "dvl"), hits(1, "gnss"));
}

TEST(MessageFaults, FramesAreHitAsBytesAre) {
  MessageFaults<wire::CanFrame> bus(1, "imu");
  const std::vector<FaultConfig> faults{fault_of(FaultKind::truncate, 1),
                                        fault_of(FaultKind::duplicate, 1)};
  bus.set(in_force(faults));
  wire::CanFrame frame;
  frame.size = 8;
  std::vector<wire::CanFrame> out;
  bus.pass(frame, [&](const wire::CanFrame& f) { out.push_back(f); });
  ASSERT_EQ(out.size(), 2u);
  EXPECT_LT(out[0].size, 8);
  EXPECT_EQ(out[0], out[1]);
}

}  // namespace message_faults_test
}  // namespace drydock::fault::test
