#include <gmock/gmock.h>

#include "hil/calibrate/outcome.hpp"
#include "rig_config/load.hpp"

namespace drydock::calibrate {
namespace {

using calibration::Unknown;
using calibration::Verdict;

constexpr double degree = M_PI / 180;

const std::string rig_text = R"([rig]
name = "boat"

[[device]]
name = "log"
kind = "emlog"
protocol = "nmea0183"
link = "memory:log"
speed_scale = 1.01  # of the spring

[[device]]
name = "compass"
kind = "attitude"
protocol = "nmea0183"
link = "memory:compass"
compass_error_deg = [1.0, 0.5, 0.0]
latency_ms = 30

[[device]]
name = "depth"
kind = "depth"
protocol = "nmea2000"
link = "memory-can:bus"
)";

enum Device : std::uint16_t { log_of_rig, compass_of_rig, depth_of_rig };

Outcome told(std::vector<std::tuple<Device, Unknown, double>> values) {
  Outcome outcome;
  outcome.gathered.rig = rig_config::load_rig_text(rig_text, "boat.toml").value();
  outcome.gathered.rig_text = rig_text;
  for (const auto& [device, unknown, value] : values)
    outcome.calibration.findings.push_back(
        {.parameter = {device, unknown}, .value = value, .verdict = Verdict::told});
  return outcome;
}

// (1 + 0.01) * (1 + 0.02) = 1.0302; errors of the compass and latencies add up.
TEST(CalibratedRig, AddsWhatWasToldToWhatTheRigFileKnew) {
  std::vector<std::string> notes;
  const auto text = calibrated_rig(told({{log_of_rig, Unknown::scale, 0.02},
                                         {log_of_rig, Unknown::latency, 0.15},
                                         {compass_of_rig, Unknown::deviation_sine, -2 * degree},
                                         {compass_of_rig, Unknown::deviation_cosine, 3 * degree},
                                         {compass_of_rig, Unknown::latency, 0.02},
                                         {depth_of_rig, Unknown::latency, -0.01}}),
                                   notes);
  EXPECT_THAT(notes, testing::IsEmpty());
  EXPECT_THAT(text, testing::HasSubstr("speed_scale = 1.0302  # of the spring\n"));
  const auto devices = rig_config::load_rig_text(text, "boat.toml").value().devices;
  EXPECT_NEAR(devices[log_of_rig].latency_s, 0.15, 1e-9);
  EXPECT_NEAR(devices[compass_of_rig].latency_s, 0.05, 1e-9);
  EXPECT_EQ(devices[depth_of_rig].latency_s, 0) << "a rig file allows none below 0";
  const auto& error = devices[compass_of_rig].compass_error_rad;
  EXPECT_NEAR(error[0], 1 * degree, 1e-9);
  EXPECT_NEAR(error[1], -1.5 * degree, 1e-9);
  EXPECT_NEAR(error[2], 3 * degree, 1e-9);
}

TEST(CalibratedRig, ThePitchOfBeamsAgainstTheirOwnTiltSensorsIsNoMounting) {
  auto outcome = told({{log_of_rig, Unknown::pitch, 2 * degree}});
  outcome.gathered.own_tilts = true;
  std::vector<std::string> notes;
  EXPECT_EQ(calibrated_rig(outcome, notes), rig_text);
}

TEST(CalibratedRig, WhatWasNotToldStaysAsItIs) {
  auto outcome = told({{log_of_rig, Unknown::scale, 0.02}});
  outcome.calibration.findings[0].verdict = Verdict::weakly;
  std::vector<std::string> notes;
  EXPECT_EQ(calibrated_rig(outcome, notes), rig_text);
}

}  // namespace
}  // namespace drydock::calibrate
