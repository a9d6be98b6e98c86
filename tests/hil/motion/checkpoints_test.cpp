// States at any index in any order, with little memory.
#include "hil/motion/vehicle/checkpoints.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

namespace {

using drydock::motion::Checkpoints;

/// A chain of states without a closed form: a state can be found only step by step.
std::uint64_t next(std::uint64_t state) {
  return state * 6364136223846793005u + 1442695040888963407u;
}

TEST(Checkpoints, AreTheSameInAnyOrderAsStepByStep) {
  constexpr std::size_t steps = 20'000;
  std::vector<std::uint64_t> chain{1};
  while (chain.size() < steps) chain.push_back(next(chain.back()));
  Checkpoints<std::uint64_t> kept(1);
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    const std::size_t index = random() % steps;
    ASSERT_EQ(kept.at(index, [](std::uint64_t s, std::size_t) { return next(s); }), chain[index]);
  }
}

TEST(Checkpoints, OneAfterTheOtherEachStepIsTakenOnce) {
  Checkpoints<int> kept(0);
  std::size_t taken = 0;
  for (std::size_t index = 0; index < 10 * 1024; ++index)
    kept.at(index, [&](int s, std::size_t step) {
      EXPECT_EQ(static_cast<std::size_t>(s), step);
      ++taken;
      return s + 1;
    });
  EXPECT_EQ(taken, 10u * 1024 - 1);
}

TEST(Checkpoints, ALongMotionCostsNoMoreThanAShortOne) {
  const auto step = [](std::uint32_t s, std::size_t) { return s + 1; };
  Checkpoints<std::uint32_t> kept(0);
  for (std::uint32_t block = 0; block < 5'000; ++block) {
    ASSERT_EQ(kept.at(block * 1024, step), block * 1024);
    ASSERT_LE(kept.firsts(), 512u);
  }
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    const auto index = static_cast<std::uint32_t>(random() % (5'000 * 1024));
    ASSERT_EQ(kept.at(index, step), index);
  }
}

}  // namespace
