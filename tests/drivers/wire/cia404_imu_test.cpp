#include "drivers/wire/canopen/cia404_imu.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/drivers/wire/can_fixture.hpp"

namespace drydock::wire {
namespace cia404_imu_test {

using cia404_imu::ImuSet;
using test::frame;
using test::text_of;

ImuSet marked(double mark, std::uint8_t node = 5) {
  ImuSet set;
  set.node = node;
  set.rate_radps = {mark, mark, mark};
  set.specific_force_mps2 = {mark, mark, mark};
  return set;
}

std::vector<CanFrame> stream(int sets) {
  std::vector<CanFrame> frames;
  for (int i = 0; i < sets; ++i) {
    for (const CanFrame& frame : encode(marked(i))) frames.push_back(frame);
  }
  return frames;
}

bool is_one_sample(const ImuSet& set) {
  for (int axis = 0; axis < 3; ++axis) {
    if (set.rate_radps[axis] != set.rate_radps[0]) return false;
    if (set.specific_force_mps2[axis] != set.rate_radps[0]) return false;
  }
  return true;
}

TEST(Cia404Imu, EncodesTheFramesThatPythonsStructGives) {
  ImuSet set;
  set.node = 5;
  set.rate_radps = {0.5, -0.25, 0.125};
  set.specific_force_mps2 = {1.5, -2.25, -9.75};
  const auto frames = encode(set);
  EXPECT_EQ(text_of(frames[0]), "185#0000003F000080BE");
  EXPECT_EQ(text_of(frames[1]), "285#0000003E0000C03F");
  EXPECT_EQ(text_of(frames[2]), "385#000010C000001CC1");
}

TEST(Cia404Imu, ResolvesAThousandthOfTheEarthRate) {
  const double rate = 7.292115e-5 * 1.001;
  auto set = marked(0);
  set.rate_radps[2] = rate;
  const auto frames = encode(set);
  const auto seen = test::only<ImuSet, Cia404Imu>({frames.begin(), frames.end()});
  EXPECT_NEAR(*seen.rate_radps[2], rate, 1e-11);
}

TEST(Cia404Imu, AnEmptyComponentComesBackEmpty) {
  auto set = marked(1);
  set.rate_radps[1].reset();
  const auto frames = encode(set);
  const auto seen = test::only<ImuSet, Cia404Imu>({frames.begin(), frames.end()});
  EXPECT_FALSE(seen.rate_radps[1]);
  EXPECT_EQ(seen.rate_radps[0], 1.0);
}

TEST(Cia404Imu, EachSingleLostFrameCostsItsSetAndIsCountedOnce) {
  for (std::size_t lost = 0; lost < 9; ++lost) {
    auto frames = stream(3);
    frames.erase(frames.begin() + static_cast<std::ptrdiff_t>(lost));
    frames.push_back(encode(marked(9))[0]);  // shows a lost last frame
    Cia404Imu::Decoder decoder;
    int sets = 0;
    for (const CanFrame& f : frames) {
      if (const auto message = decoder.receive(f)) {
        ++sets;
        EXPECT_TRUE(is_one_sample(std::get<ImuSet>(*message))) << lost;
      }
    }
    EXPECT_EQ(sets, 2) << lost;
    EXPECT_EQ(decoder.counters().bad_checksums, 1u) << lost;
  }
}

TEST(Cia404Imu, FramesOutOfOrderGiveNoSet) {
  const auto f = encode(marked(1));
  EXPECT_TRUE(test::decode_all<Cia404Imu>({f[1], f[0], f[2]}).empty());
  EXPECT_TRUE(test::decode_all<Cia404Imu>({f[0], f[2], f[1]}).empty());
  EXPECT_TRUE(test::decode_all<Cia404Imu>({f[2], f[1], f[0]}).empty());
  EXPECT_EQ(test::decode_all<Cia404Imu>({f[0], f[0], f[1], f[2]}).size(), 1u);
}

TEST(Cia404Imu, SetsOfTwoNodesMayInterleave) {
  const auto a = encode(marked(1, 5)), b = encode(marked(2, 6));
  const auto messages = test::decode_all<Cia404Imu>({a[0], b[0], a[1], b[1], b[2], a[2]});
  ASSERT_EQ(messages.size(), 2u);
  EXPECT_EQ(std::get<ImuSet>(messages[0]).node, 6);
  EXPECT_EQ(std::get<ImuSet>(messages[1]).node, 5);
}

TEST(Cia404Imu, APdoOfAnotherLengthBreaksItsSet) {
  const auto f = encode(marked(1));
  CanFrame cut = f[1];
  cut.size = 4;
  EXPECT_TRUE(test::decode_all<Cia404Imu>({f[0], cut, f[2]}).empty());
}

RC_GTEST_PROP(Cia404Imu, UpToTwoLostFramesInARowNeverMixTwoSamples, ()) {
  auto frames = stream(8);
  const auto at = *rc::gen::inRange<std::size_t>(0, frames.size() - 2);
  const auto count = *rc::gen::inRange<std::ptrdiff_t>(1, 3);
  const auto begin = frames.begin() + static_cast<std::ptrdiff_t>(at);
  frames.erase(begin, begin + count);
  for (const auto& message : test::decode_all<Cia404Imu>(frames)) {
    RC_ASSERT(is_one_sample(std::get<ImuSet>(message)));
  }
}

}  // namespace cia404_imu_test
}  // namespace drydock::wire
