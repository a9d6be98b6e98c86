#include <gtest/gtest.h>

#include "tests/estimators/pipeline/counting_new.hpp"
#include "tests/estimators/pipeline/resting_vehicle.hpp"
#include "tests/estimators/pipeline/support.hpp"

namespace drydock::pipeline {
namespace {

struct LastEstimate final : EstimateListener {
  void on_attitude(const AttitudeEstimate& estimate) override { last = estimate; }
  void on_innovation(const InnovationReport&) override { ++innovations; }
  AttitudeEstimate last;
  int innovations = 0;
};

TEST(Pipeline, AllocatesNothingPerSample) {
  struct Case {
    int window_ms;
    EstimatorKind kind;
  };
  LevelingOptions robust;
  robust.log = test::log_device;
  robust.filter.latitude_rad = 0.6;
  LevelingOptions augmented = robust;
  augmented.kind = leveling::FilterKind::augmented;
  MixingOptions mixing;
  mixing.log = test::log_device;
  for (const auto& [window_ms, kind] :
       {Case{0, robust}, Case{100, robust}, Case{100, augmented}, Case{100, mixing}}) {
    LastEstimate listener;
    auto options = test::moving(std::chrono::milliseconds{window_ms});
    options.estimators[0].kind = kind;
    auto pipeline = make_pipeline(options, listener);
    const auto feed = [&](int from_ms, int to_ms) {
      for (int t = from_ms; t < to_ms; t += 10) {
        if (t % 500 == 0) pipeline->receive(test::water_speed(t - 100));
        pipeline->receive(test::imu(t));
        pipeline->advance(test::at_ms(t + 5));
      }
    };
    feed(0, 1000);
    const std::size_t before = test::allocations();
    feed(1000, 20000);
    EXPECT_EQ(test::allocations(), before);
    EXPECT_GT(listener.last.valid_at, test::at_ms(19000));
    EXPECT_EQ(listener.innovations, std::holds_alternative<LevelingOptions>(kind) ? 39 : 0);
  }
}

TEST(Pipeline, AllocatesNothingPerStepOfAnInertialNavigation) {
  for (const auto method :
       {InertialMethod::sensors, InertialMethod::coupled, InertialMethod::paper}) {
    test::RestingVehicle bench(method);
    bench.listener.all.reserve(1000);
    bench.run(10);
    const std::size_t before = test::allocations();
    bench.run(60);  // with DVL, log and depth
    bench.skip(0.3);
    bench.run(1);
    EXPECT_EQ(test::allocations(), before);
    EXPECT_GT(bench.listener.all.size(), 700u);
    EXPECT_GT(bench.listener.innovations[6].reports, 60u);
  }
}

}  // namespace
}  // namespace drydock::pipeline
