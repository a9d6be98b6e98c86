// Ticks of 0.1 ms. Every message is 2 ms on its way.
#include "drivers/device/device_clock.hpp"

#include <gtest/gtest.h>

namespace drydock::device {
namespace device_clock_test {

using namespace std::chrono_literals;

class Ticks {
 public:
  /// A message of that time; its ticks are off by `wrong`, or it is late.
  std::chrono::nanoseconds error_at(std::chrono::nanoseconds true_time,
                                    std::chrono::nanoseconds wrong = 0ns,
                                    std::chrono::nanoseconds late = 0ns) {
    const auto time = clock_.map(static_cast<std::uint32_t>((true_time + wrong) / 100us),
                                 Stamp{true_time + 2ms + late});
    return time.host - Stamp{true_time};
  }

 private:
  DeviceClock clock_{100us};
};

TEST(DeviceClock, OneDamagedTickMovesNothingBehindIt) {
  Ticks ticks;
  for (int i = 1; i < 10; ++i) EXPECT_EQ(ticks.error_at(i * 500ms), 2ms);
  EXPECT_EQ(ticks.error_at(5000ms, 205ms), 2ms) << "as it came";
  for (int i = 11; i < 100; ++i) EXPECT_EQ(ticks.error_at(i * 500ms), 2ms) << i;
}

TEST(DeviceClock, BeginsAnewOnlyBehindAJumpThatGoesOn) {
  Ticks ticks;
  for (int i = 1; i < 10; ++i) EXPECT_EQ(ticks.error_at(i * 500ms), 2ms);
  EXPECT_EQ(ticks.error_at(5000ms, 1700s), 2ms);
  EXPECT_EQ(ticks.error_at(5500ms, 205ms), 2ms) << "the next one is damaged too";
  for (int i = 12; i < 20; ++i) EXPECT_EQ(ticks.error_at(i * 500ms), 2ms) << i;
  for (int i = 20; i < 25; ++i)
    EXPECT_EQ(ticks.error_at(i * 500ms, 1700s), 2ms) << "it was switched off and on";
  EXPECT_EQ(ticks.error_at(12500ms, 1700s, 80ms), 2058us) << "by its own time";
}

TEST(DeviceClock, TwoTicksThatAreOffByTheSameBitMoveNothingBehindThem) {
  Ticks ticks;
  for (int i = 1; i < 10; ++i) EXPECT_EQ(ticks.error_at(i * 500ms), 2ms);
  EXPECT_EQ(ticks.error_at(5000ms, 205ms), 2ms);
  EXPECT_EQ(ticks.error_at(5500ms, 205ms), 2ms);
  for (int i = 12; i < 100; ++i) EXPECT_EQ(ticks.error_at(i * 500ms), 2ms) << i;
}

TEST(DeviceClock, TakesAnEarlierTimeThatTheNextMessagesConfirm) {
  Ticks ticks;
  EXPECT_EQ(ticks.error_at(500ms, 0ns, 80ms), 82ms) << "a bus that was busy at first";
  EXPECT_EQ(ticks.error_at(1000ms), 2ms);
  EXPECT_EQ(ticks.error_at(1500ms), 2ms);
  EXPECT_EQ(ticks.error_at(2000ms), 2ms);
  EXPECT_EQ(ticks.error_at(2500ms, 0ns, 80ms), 2058us) << "580 ms on, by its own time";
}

TEST(DeviceClock, TakesAnEarlierTimeAtOnceThatABusExplains) {
  Ticks ticks;
  EXPECT_EQ(ticks.error_at(500ms, 0ns, 3ms), 5ms);
  EXPECT_EQ(ticks.error_at(1000ms), 2ms);
  EXPECT_EQ(ticks.error_at(1500ms, 0ns, 3ms), 2050us + 300ns);
}

}  // namespace device_clock_test
}  // namespace drydock::device
