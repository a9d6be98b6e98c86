#include "estimators/pipeline/missing_estimates.hpp"

#include <gtest/gtest.h>

#include "tests/estimators/pipeline/support.hpp"

namespace drydock::pipeline {
namespace {

using std::chrono::milliseconds;

/// An IMU at 100 Hz that is silent from 20 s to 50 s of 80 s, with a log at 2 Hz.
struct SilentForAWhile {
  explicit SilentForAWhile(milliseconds window)
      : pipeline(*make_pipeline(test::moving(window), estimates)) {}
  void run(int from_s, int to_s, bool imu) {
    for (int t = 1000 * from_s; t < 1000 * to_s; t += 10) {
      if (t % 500 == 0) pipeline.receive(test::water_speed(t));
      if (imu) pipeline.receive(test::imu(t));
    }
  }
  test::Estimates estimates;
  Pipeline pipeline;
};

TEST(MissingEstimates, CountAsNotValid) {
  for (const auto window : {milliseconds{0}, milliseconds{200}}) {
    SilentForAWhile run(window);
    run.run(0, 20, true);
    const auto before = run.pipeline.status(0);
    EXPECT_EQ(before.missing, 0u);
    run.run(20, 50, false);
    // 30 s less the last half second without the log's time: 100 a second.
    EXPECT_NEAR(static_cast<double>(run.pipeline.status(0).missing), 2950, 60);
    EXPECT_LT(valid_share(before, run.pipeline.status(0)).value_or(1), 0.01);  // what waited
    run.run(50, 80, true);
    run.pipeline.flush();
    const auto status = run.pipeline.status(0);
    EXPECT_NEAR(static_cast<double>(status.missing + status.estimates), 8000, 10);
    EXPECT_NEAR(*valid_share({}, status), static_cast<double>(status.valid_estimates) / 8000, 1e-3);
  }
}

TEST(MissingEstimates, AreNoneWhileGapsAreBridged) {
  SilentForAWhile run(milliseconds{200});
  run.run(0, 20, true);
  for (int t = 20000; t < 40000; t += 400) {
    if (t % 2000 == 0) run.pipeline.receive(test::water_speed(t));
    run.pipeline.receive(test::imu(t));
  }
  EXPECT_EQ(run.pipeline.status(0).missing, 0u);
}

}  // namespace
}  // namespace drydock::pipeline
