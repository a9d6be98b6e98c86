// The scorecard's results for two runs that were made by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "hil/scorecard/detection.hpp"
#include "hil/scorecard/reference.hpp"
#include "hil/scorecard/score.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace score_test {

using namespace drydock;
using namespace drydock::scorecard;

constexpr Window window{.warm_up_s = 10, .fault_s = 10, .after_s = 10};

/// A depth sensor at 10 Hz that sinks at 0.5 m/s. Its resolution is 1 cm.
double depth_at(double t_s) { return std::round(50 * t_s) / 100; }

void say(DeviceRecord& device, double valid_s, double received_s, double depth) {
  auto& series = device.series[0];
  series.name = "depth_m";
  series.samples.push_back({valid_s, received_s, depth, device.arrivals.size()});
  device.arrivals.push_back({received_s, 1, 1});
}

RunRecord sound_run() {
  RunRecord run;
  run.devices.resize(1);
  for (int k = 0; k < 300; ++k) say(run.devices[0], 0.1 * k, 0.1 * k + 0.01, depth_at(0.1 * k));
  for (int k = 1; k <= 300; ++k) {
    Look look;
    look.at_s = 0.1 * k;
    run.devices[0].looks.push_back(look);
  }
  return run;
}

rig_config::Rig one_depth_sensor() {
  rig_config::Rig rig;
  rig.devices.resize(1);
  rig.devices[0].name = "depth";
  rig.devices[0].kind = rig_config::DeviceKind::depth;
  return rig;
}

Pair fault(rig_config::FaultKind kind) {
  Pair pair;
  pair.fault.device = "depth";
  pair.fault.kind = kind;
  return pair;
}

Score score(const RunRecord& run, rig_config::FaultKind kind) {
  return score_of(one_depth_sensor(), window, fault(kind), Reference(sound_run()), run);
}

TEST(Reference, AllowsTwiceWhatResolutionPutsANumberOffItsNeighboursLine) {
  // 5.3 cm per sample, resolution 1 cm: up to 1 cm off the line between the neighbours.
  RunRecord run = sound_run();
  for (Sample& sample : run.devices[0].series[0].samples)
    sample.value = std::round(53 * sample.valid_s) / 100;
  const Reference reference(std::move(run));
  const auto expected = reference.at(0, 0, 15.05);
  ASSERT_TRUE(expected);
  EXPECT_NEAR(expected->value, 7.9765, 0.01);
  EXPECT_LE(expected->tolerance, 0.021);
  EXPECT_TRUE(reference.sound(0, 0, {15.05, 15.06, 7.98, 0}));
  EXPECT_FALSE(reference.sound(0, 0, {15.05, 15.06, 8.03, 0}));
  EXPECT_FALSE(reference.at(0, 0, 40)) << "it said nothing then";
  EXPECT_NEAR(reference.period_s(0, 0), 0.1, 1e-9);
}

TEST(Score, ARunThatIsTheSameHasNothingWrongAndNothingSeen) {
  const Score s = score(sound_run(), rig_config::FaultKind::flip);
  EXPECT_FALSE(s.detect_s);
  EXPECT_NEAR(s.recover_s.value(), 0.01, 1e-9) << "the first message behind the fault";
  EXPECT_EQ(s.lost, 0);
  EXPECT_EQ(s.wrong, 0u);
  EXPECT_EQ(s.mistimed, 0u);
}

TEST(Score, ANumberThatNobodyMeasuredIsWrong) {
  auto run = sound_run();
  run.devices[0].series[0].samples[150].value += 40;
  const Score s = score(run, rig_config::FaultKind::flip);
  EXPECT_EQ(s.wrong, 1u);
  EXPECT_EQ(s.lies, 0u);
  EXPECT_NE(s.example.find("depth depth_m = 47.5 at 15.000 s, expected 7.5"), std::string::npos)
      << s.example;
}

TEST(Score, ASensorThatIsMadeToMeasureWrongLiesAndItsDriverDoesNot) {
  auto run = sound_run();
  for (std::size_t k = 100; k < 200; ++k) run.devices[0].series[0].samples[k].value += 5;
  const Score s = score(run, rig_config::FaultKind::bias);
  EXPECT_EQ(s.wrong, 0u);
  EXPECT_EQ(s.lies, 100u);
  EXPECT_NEAR(s.recover_s.value(), 0.01, 1e-9);
}

TEST(Score, AMessageThatWasHeldIsMistimedNotWrong) {
  auto run = sound_run();
  for (std::size_t k = 120; k < 140; ++k) {
    run.devices[0].series[0].samples[k].valid_s += 0.5;
    run.devices[0].series[0].samples[k].received_s += 0.5;
    run.devices[0].arrivals[k].received_s += 0.5;
  }
  const Score s = score(run, rig_config::FaultKind::delay);
  EXPECT_EQ(s.wrong, 0u);
  EXPECT_EQ(s.mistimed, 20u);
}

TEST(Score, SilenceIsCountedAndItsEndTimed) {
  RunRecord run;
  run.devices.resize(1);
  for (int k = 0; k < 300; ++k)
    if (k < 100 || k >= 230) say(run.devices[0], 0.1 * k, 0.1 * k + 0.01, depth_at(0.1 * k));
  run.devices[0].changes.push_back({12, device::State::stale});
  run.devices[0].changes.push_back({23.01, device::State::streaming});
  const Score s = score(run, rig_config::FaultKind::hang);
  EXPECT_EQ(s.lost, 130);
  EXPECT_NEAR(s.detect_s.value(), 2, 1e-9);
  EXPECT_EQ(s.sign, "stale");
  EXPECT_NEAR(s.recover_s.value(), 3.01, 1e-9);
}

TEST(Score, ADeviceThatStaysSilentHasNotRecovered) {
  RunRecord run;
  run.devices.resize(1);
  for (int k = 0; k < 100; ++k) say(run.devices[0], 0.1 * k, 0.1 * k + 0.01, depth_at(0.1 * k));
  EXPECT_FALSE(score(run, rig_config::FaultKind::hang).recover_s);
}

TEST(Detection, TheFirstOfAllSignsCountsAndOneOfTheUsualRunDoesNot) {
  auto run = sound_run();
  for (auto& look : run.devices[0].looks) {
    if (look.at_s > 14) look.skipped = 7;
    if (look.at_s > 12.45) look.bad_checksums = 1;
  }
  const auto sign = first_sign(0, window, Reference(sound_run()), run);
  ASSERT_TRUE(sign);
  EXPECT_EQ(sign->what, "bad checksum");
  EXPECT_NEAR(sign->at_s, 12.5, 1e-9);
  EXPECT_FALSE(first_sign(0, window, Reference(run), run));
}

/// Estimates of a tilt at 10 Hz: 2 sigmas wrong, but 6 from `wrong_s` on, and valid until
/// `valid_s`.
RunRecord with_estimates(double wrong_s, double valid_s) {
  RunRecord run = sound_run();
  run.estimators.resize(1);
  for (int k = 0; k < 300; ++k) {
    const double at_s = 0.1 * k, sigmas = at_s < wrong_s ? 2 : 6;
    run.estimators[0].push_back({.at_s = at_s,
                                 .tilt_deg = 0.1 * sigmas,
                                 .nees = sigmas * sigmas / 2,
                                 .horizontal_m = {},
                                 .valid = at_s < valid_s,
                                 .sigmas = sigmas});
  }
  return run;
}

EstimatorScore estimator_score(double wrong_s, double valid_s) {
  rig_config::Rig rig = one_depth_sensor();
  rig.estimators.resize(1);
  const Reference reference(with_estimates(1000, 1000));
  return score_of(rig, window, fault(rig_config::FaultKind::bias), reference,
                  with_estimates(wrong_s, valid_s))
      .estimators.at(0);
}

TEST(Score, AnEstimateIsWrongWhileValidUntilItSaysOtherwise) {
  const auto honest = estimator_score(14.95, 16.45);
  EXPECT_NEAR(honest.wrong_while_valid_s, 1.5, 1e-6);
  EXPECT_NEAR(honest.valid_share, 65. / 200, 1e-6);  // of the 20 s since the fault's start
  EXPECT_NEAR(honest.nees.value(), (50 * 2. + 15 * 18) / 65, 1e-6);
  const auto dishonest = estimator_score(14.95, 1000);
  EXPECT_NEAR(dishonest.wrong_while_valid_s, 15, 1e-6);
  EXPECT_EQ(dishonest.valid_share, 1);
  const auto mute = estimator_score(14.95, 0);
  EXPECT_FALSE(mute.nees);
  EXPECT_EQ(mute.wrong_while_valid_s, 0);
}

}  // namespace score_test
