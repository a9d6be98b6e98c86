#include <gtest/gtest.h>

#include "hil/motion/make_trajectory.hpp"
#include "hil/summary/expect_watch.hpp"
#include "hil/summary/scribe.hpp"
#include "rig_config/load.hpp"

/// The host's clock is set during a run whose true motion follows a steady clock.
namespace drydock::summary::clock_step_test {
namespace {

using measurement::Stamp;
using namespace std::chrono_literals;

const Stamp noon = measurement::stamp_from_ns(1'700'000'000'000'000'000);

TEST(SummaryAcrossAStep, APerfectEstimatorStaysPerfectAndKeepsItsRate) {
  for (const auto step : {3600s, -3600s}) {
    auto rig = rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value();
    rig.expects.assign(1, {});
    rig.expects[0].estimator = rig.estimators[0].name;
    rig.expects[0].after_s = 5;
    rig.expects[0].figures.push_back({"roll_rms_deg", {.high = 1e-9}, 0});
    const auto motion = motion::make_trajectory(rig.mission, noon);
    Scribe scribe(rig, motion.get(), noon, 40);
    ExpectWatch watch(rig, motion.get(), noon, [&](Stamp) {
      return ExpectWatch::Counts{{}, std::vector<pipeline::EstimatorStatus>(rig.estimators.size())};
    });
    for (int i = 0; i < 400; ++i) {
      const Stamp steady = noon + i * 100ms;
      const bool is_set = i >= 200;
      if (i == 200) {
        scribe.on_clock_step(step);
        watch.on_clock_step(step);
      }
      const auto truth = motion->at(steady);
      host::Estimate estimate;
      estimate.attitude.valid_at = is_set ? steady + step : steady;
      estimate.attitude.roll_rad = truth.roll_rad;
      estimate.attitude.pitch_rad = truth.pitch_rad;
      estimate.attitude.yaw_rad = truth.yaw_rad;
      estimate.attitude.covariance.setIdentity();
      scribe.on_estimate(estimate);
      watch.tick(steady);
      watch.on_estimate(estimate);
    }
    Summary whole;
    whole.duration_s = 40;
    scribe.write(whole);
    watch.write(whole, std::vector<pipeline::EstimatorStatus>(rig.estimators.size()));
    const auto& seen = whole.estimators.at(0);
    EXPECT_NEAR(seen.rate_hz.value_or(0), 10, 1e-6) << step.count();
    ASSERT_TRUE(seen.whole_run);
    EXPECT_LT(seen.whole_run->roll_rms_deg, 1e-9) << step.count();
    EXPECT_LT(seen.whole_run->pitch_rms_deg, 1e-9) << step.count();
    EXPECT_NEAR(whole.traces.at(0).t_s.back(), 39.9, 0.2) << step.count();
    EXPECT_TRUE(whole.verdicts.at(0).passed) << whole.verdicts.at(0).measured;
  }
}

}  // namespace
}  // namespace drydock::summary::clock_step_test
