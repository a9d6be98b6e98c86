// A truth that nobody hears is not computed.
#include <gtest/gtest.h>

#include "hil/bench/run.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "rig_config/load.hpp"

namespace drydock::bench {
namespace unheard_truth_test {

/// The motion of a mission, and how often it was asked for.
class Counted final : public motion::Trajectory {
 public:
  explicit Counted(const rig_config::Rig& rig)
      : motion_(
            motion::make_trajectory(rig.mission, measurement::stamp_from_ns(rig.start_utc_ns))) {}

  motion::Truth at(motion::Stamp time) const override {
    ++asked;
    return motion_->at(time);
  }
  motion::Stamp start() const override { return motion_->start(); }
  motion::Stamp end() const override { return motion_->end(); }
  const ocean::Ocean& ocean() const override { return motion_->ocean(); }

  mutable int asked = 0;

 private:
  std::unique_ptr<motion::Trajectory> motion_;
};

/// Counts the truths that it is told, and may say that it needs none.
struct Ear final : Follower {
  explicit Ear(bool needs) : needs_truth(needs) {}
  bool hears_truth() const override { return needs_truth; }
  void on_truth(const host::Estimate&) override { ++told; }

  bool needs_truth;
  int told = 0;
};

/// How often a run of the demo rig for so long asks for its motion.
int asked(Ear& ear, double seconds) {
  const auto rig = rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value();
  const Counted motion(rig);
  RunOptions options;
  options.duration_s = seconds;
  options.quiet = true;
  options.followers = {&ear};
  options.parts.motion = &motion;
  testing::internal::CaptureStdout();
  run_lockstep(rig, options);
  testing::internal::GetCapturedStdout();
  return motion.asked;
}

TEST(UnheardTruth, IsNotComputedBetweenEstimates) {
  Ear hearing(true), deaf(false);
  const int heard = asked(hearing, 20), unheard = asked(deaf, 20);
  EXPECT_GT(hearing.told, 20 * 15) << "every 40 to 60 ms";
  EXPECT_EQ(deaf.told, 0);
  EXPECT_EQ(heard - unheard, hearing.told);
}

}  // namespace unheard_truth_test
}  // namespace drydock::bench
