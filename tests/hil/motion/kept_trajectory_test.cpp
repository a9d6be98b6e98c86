#include "hil/motion/kept_trajectory.hpp"

#include <gtest/gtest.h>

namespace drydock::motion {
namespace {

/// Its height is how often it was asked.
class Counting final : public Trajectory {
 public:
  Truth at(Stamp time) const override {
    Truth truth;
    truth.at = time;
    truth.height_m = ++asked_;
    return truth;
  }
  Stamp start() const override { return Stamp{}; }
  Stamp end() const override { return Stamp{std::chrono::hours{1}}; }

 private:
  mutable int asked_ = 0;
};

Stamp at_ms(int ms) { return Stamp{std::chrono::milliseconds{ms}}; }

TEST(KeptTrajectory, AsksForATimeOnce) {
  const KeptTrajectory motion(std::make_unique<Counting>());
  EXPECT_EQ(motion.at(at_ms(10)).height_m, 1);
  EXPECT_EQ(motion.at(at_ms(20)).height_m, 2);
  EXPECT_EQ(motion.at(at_ms(10)).height_m, 1);
  EXPECT_EQ(motion.at(at_ms(20)).at, at_ms(20));
  EXPECT_EQ(motion.end(), Stamp{std::chrono::hours{1}});
}

TEST(KeptTrajectory, AsksEachTimeForWhatItHasNoRoom) {
  const KeptTrajectory motion(std::make_unique<Counting>());
  const int full = KeptTrajectory::most_kept;
  for (int ms = 0; ms < full; ++ms) motion.at(at_ms(ms));
  EXPECT_EQ(motion.at(at_ms(full)).height_m, full + 1);
  EXPECT_EQ(motion.at(at_ms(full)).height_m, full + 2);
  EXPECT_EQ(motion.at(at_ms(full - 1)).height_m, full) << "the last one that had room";
}

}  // namespace
}  // namespace drydock::motion
