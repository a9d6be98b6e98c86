#include "estimators/pipeline/pipeline.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "tests/estimators/pipeline/support.hpp"

namespace drydock::pipeline {
namespace {

using std::chrono::milliseconds;
using test::at_ms;
using test::Estimates;
using test::imu;
using test::imu_device;
using test::leveling_of;
using test::log_device;
using test::Measurement;
using test::moving;
using test::water_speed;

/// Two seconds at 100 Hz with a changing turn, the log at 5 Hz, in the order of valid_at.
std::vector<Measurement> two_seconds() {
  std::vector<Measurement> all;
  for (int t = 0; t < 2000; t += 10) {
    if (t % 200 == 0) all.emplace_back(water_speed(t - 3, 2 + t * 1e-4));
    all.emplace_back(imu(t, t * 1e-4));
  }
  return all;
}

std::vector<AttitudeEstimate> estimates_of(const std::vector<Measurement>& measurements,
                                           const PipelineOptions& options) {
  Estimates estimates;
  auto pipeline = make_pipeline(options, estimates);
  for (const Measurement& m : measurements) pipeline->receive(m);
  pipeline->flush();
  return estimates.all;
}

bool same_bits(const std::vector<AttitudeEstimate>& a, const std::vector<AttitudeEstimate>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    const double xs[] = {x.roll_rad, x.pitch_rad}, ys[] = {y.roll_rad, y.pitch_rad};
    return x.valid_at == y.valid_at && x.fed_by == y.fed_by && !std::memcmp(xs, ys, sizeof xs) &&
           !std::memcmp(x.covariance.data(), y.covariance.data(), 4 * sizeof(double));
  });
}

RC_GTEST_PROP(Pipeline, AnyDelaysWithinTheWindowGiveBitIdenticalEstimates, ()) {
  const auto in_order = two_seconds();
  const auto expected = estimates_of(in_order, moving(milliseconds{100}));
  RC_ASSERT(expected.size() == 200u);

  // Each measurement arrives up to one window after its valid_at.
  std::vector<std::pair<test::Stamp, Measurement>> arrivals;
  for (const Measurement& m : in_order) {
    arrivals.emplace_back(origin_of(m).valid_at + milliseconds{*rc::gen::inRange(0, 101)}, m);
  }
  std::stable_sort(arrivals.begin(), arrivals.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Measurement> delayed;
  for (auto& [when, m] : arrivals) delayed.push_back(m);
  RC_ASSERT(same_bits(estimates_of(delayed, moving(milliseconds{100})), expected));
}

TEST(Pipeline, TheWindowDoesNotChangeWhatComesInOrder) {
  const auto measurements = two_seconds();
  const auto immediate = estimates_of(measurements, moving(milliseconds{0}));
  EXPECT_EQ(immediate.size(), 200u);
  EXPECT_TRUE(same_bits(immediate, estimates_of(measurements, moving(milliseconds{200}))));
}

TEST(Pipeline, WithoutWindowAnEstimateComesInTheCallThatBroughtTheSample) {
  Estimates estimates;
  auto pipeline = make_pipeline(moving(milliseconds{0}), estimates);
  pipeline->receive(water_speed(0));
  for (int t = 0; t < 100; t += 10) {
    pipeline->receive(imu(t));
    ASSERT_FALSE(estimates.all.empty());
    EXPECT_EQ(estimates.all.back().valid_at, at_ms(t));
  }
}

TEST(Pipeline, MeasurementsLeaveOnceSomethingNewerThanTheWindowIsKnown) {
  Estimates estimates;
  auto pipeline = make_pipeline(moving(milliseconds{50}), estimates);
  pipeline->receive(water_speed(-1));
  pipeline->receive(imu(0));
  pipeline->receive(imu(50));
  EXPECT_TRUE(estimates.all.empty());
  pipeline->receive(imu(51));
  ASSERT_EQ(estimates.all.size(), 1u);
  pipeline->advance(at_ms(101));  // all sensors are silent, but time passes
  ASSERT_EQ(estimates.all.size(), 2u);
  EXPECT_EQ(estimates.all.back().valid_at, at_ms(50));
  pipeline->flush();
  EXPECT_EQ(estimates.all.back().valid_at, at_ms(51));
}

TEST(Pipeline, WhatComesBehindTheWindowIsCountedLate) {
  Estimates estimates;
  auto pipeline = make_pipeline(moving(milliseconds{50}), estimates);
  pipeline->receive(water_speed(0));
  for (int t = 0; t <= 1000; t += 10) pipeline->receive(imu(t));
  const auto before = estimates.all.size();
  pipeline->receive(imu(905));          // older than the last IMU sample that left
  pipeline->receive(water_speed(400));  // more than half a second late
  pipeline->receive(water_speed(600));
  EXPECT_EQ(estimates.all.size(), before);
  EXPECT_EQ(pipeline->counters()[imu_device].late, 1u);
  EXPECT_EQ(pipeline->counters()[log_device].late, 1u);
  EXPECT_EQ(pipeline->counters()[log_device].delayed, 1u);
}

TEST(Pipeline, CountersAddUpToWhatWasReceived) {
  Estimates estimates;
  auto pipeline = make_pipeline(moving(milliseconds{0}), estimates);
  for (const Measurement& m : two_seconds()) pipeline->receive(m);
  pipeline->receive(imu(0));
  auto absurd = imu(3000);
  absurd.specific_force.x() = 1e9;
  pipeline->receive(absurd);
  auto silent = water_speed(1990);
  silent.longitudinal_mps.reset();
  pipeline->receive(silent);
  measurement::DepthSample depth;
  depth.origin.device = 8;
  pipeline->receive(depth);

  const DeviceCounters& of_imu = pipeline->counters()[imu_device];
  EXPECT_EQ(of_imu.received, 202u);
  EXPECT_EQ(of_imu.accepted, 200u);
  EXPECT_EQ(of_imu.late, 1u);
  EXPECT_EQ(of_imu.refused, 1u);
  const DeviceCounters& of_log = pipeline->counters()[log_device];
  EXPECT_EQ(of_log.received, 11u);
  EXPECT_EQ(of_log.accepted, 10u);
  EXPECT_EQ(of_log.unused, 1u);
  EXPECT_EQ(pipeline->counters()[8].unused, 1u);
}

TEST(Pipeline, AFullBufferLetsTheOldestGoEarlyAndCountsIt) {
  PipelineOptions options = moving(milliseconds{1000});
  options.reorder_capacity = 10;
  Estimates estimates;
  auto pipeline = make_pipeline(options, estimates);
  pipeline->receive(water_speed(-1));
  for (int t = 0; t < 200; t += 10) pipeline->receive(imu(t));
  EXPECT_EQ(pipeline->overflows(), 11u);
  EXPECT_EQ(estimates.all.size(), 10u);
}

TEST(Pipeline, EstimatorsOfDifferentDevicesDoNotDisturbEachOther) {
  PipelineOptions options = moving(milliseconds{0});
  options.estimators.push_back(options.estimators[0]);
  options.estimators[1].imu = 4;
  Estimates estimates;
  auto pipeline = make_pipeline(options, estimates);
  pipeline->receive(water_speed(0));
  for (int t = 0; t < 200; t += 10) {
    pipeline->receive(imu(t));
    pipeline->receive(imu(t - 40, 0, 4));  // a slower wire, with its own samples in order
  }
  EXPECT_EQ(pipeline->counters()[4].late, 0u);
  EXPECT_EQ(pipeline->status(0).estimates, 20u);
  EXPECT_EQ(pipeline->status(1).estimates, 20u);
  EXPECT_EQ(estimates.all[1].estimator, 1);
}

std::string error_of(const PipelineOptions& options) {
  Estimates estimates;
  const auto pipeline = make_pipeline(options, estimates);
  return pipeline.has_error() ? pipeline.error().message : std::string{"no error"};
}

TEST(MakePipeline, SaysInOneLineWhatIsWrongAndWhatIsAllowed) {
  PipelineOptions options = moving(milliseconds{0});
  EXPECT_EQ(error_of(options), "no error");
  leveling_of(options).log.reset();
  EXPECT_EQ(error_of(options),
            "estimator 'attitude': a moving vehicle needs a speed log, allowed: log = a device, or "
            "stationary = true");
  leveling_of(options).stationary = true;
  EXPECT_EQ(error_of(options), "no error");
  options.estimators[0].imu = 32;
  EXPECT_EQ(error_of(options), "estimator 'attitude': device index out of range, allowed: 0 to 31");
  EXPECT_EQ(error_of(moving(milliseconds{-1})),
            "reorder window below 0 or capacity 0, allowed: 0 s or more, 1 or more");
}

TEST(MakePipeline, WhoAsksForTheValueOfARefusalGetsItsLineAsAnException) {
  Estimates estimates;
  EXPECT_THROW(make_pipeline(moving(milliseconds{-1}), estimates).value(), std::invalid_argument);
}

}  // namespace
}  // namespace drydock::pipeline
