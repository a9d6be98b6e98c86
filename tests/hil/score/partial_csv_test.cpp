// Estimates that give a part of a state, as most programs do: what they give is scored.
#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

#include "tests/hil/score/partial.hpp"

namespace drydock::score::partial_test {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// `line`: the cells behind the time, for each second.
Estimates csv(const std::string& head, const std::function<std::string(int)>& line) {
  std::string text = "t_s," + head + "\n";
  for (int t = 0; t <= 20; ++t) text += std::to_string(t) + "," + line(t) + "\n";
  std::istringstream in(text);
  const auto read = read_csv(in, "a.csv", origin);
  EXPECT_TRUE(read) << read.error().line;
  return *read;
}

TEST(APartialCsv, OfPositionsInTwoDimensionsIsScoredInTwo) {
  const auto estimates =
      csv("north_m,east_m", [](int t) { return "3," + std::to_string(2 * t + 4); });
  const auto errors = errors_against_truth(estimates);
  EXPECT_NEAR(errors.ate_m->rms, 5, 1e-12);
  EXPECT_NEAR(errors.ate_m->max, 5, 1e-12);
  EXPECT_NEAR(*errors.horizontal_rms_m, 5, 1e-12);
  EXPECT_FALSE(errors.vertical_rms_m);
  EXPECT_NEAR(errors.rpe_m->max, 0, 1e-12);
  EXPECT_THAT(errors.told, ElementsAre(21, 21, 0, 0, 0, 0, 0, 0, 0));
  EXPECT_NEAR(errors_against_truth(estimates, Alignment::start).ate_m->max, 0, 1e-12);
  EXPECT_NEAR(errors_against_truth(estimates, Alignment::yaw).ate_m->max, 0, 1e-12);
}

TEST(APartialCsv, InDegreesNeedsNoHeight) {
  const auto at = frame::at_ned_offset(origin, {3, 4, 0});
  const auto errors = errors_against_truth(csv("longitude_deg,latitude_deg", [&](int t) {
    const auto place = frame::at_ned_offset(at, {0, 2. * t, 0});
    std::ostringstream text;
    text.precision(12);
    text << place.longitude_rad / degree << ',' << place.latitude_rad / degree;
    return text.str();
  }));
  EXPECT_NEAR(errors.ate_m->rms, 5, 1e-3);
  EXPECT_FALSE(errors.vertical_rms_m);
}

TEST(APartialCsv, OfAHeightAloneIsScoredVertically) {
  const auto errors = errors_against_truth(csv("altitude_m", [](int) { return "-22"; }));
  EXPECT_NEAR(*errors.vertical_rms_m, 2, 1e-12);
  EXPECT_FALSE(errors.horizontal_rms_m);
  EXPECT_THAT(errors.told, ElementsAre(0, 0, 21, 0, 0, 0, 0, 0, 0));
}

TEST(APartialCsv, OfAnAttitudeAloneHasTheErrorsOfItsAngles) {
  const auto errors = errors_against_truth(
      csv("roll_deg,pitch_deg,yaw_deg,roll_sigma_deg,pitch_sigma_deg,heading_sigma_deg",
          [](int) { return "6,-3,92,1,1,1"; }));
  EXPECT_NEAR(errors.roll_deg->rms, 1, 1e-9);
  EXPECT_NEAR(errors.pitch_deg->rms, 0, 1e-9);
  EXPECT_NEAR(errors.heading_deg->rms, 2, 1e-9);
  EXPECT_NEAR(errors.heading_deg->max, 2, 1e-9);
  EXPECT_NEAR(*errors.attitude_nees.mean, 5. / 3, 1e-9);
  EXPECT_NEAR(errors.rpe_deg->rms, 0, 1e-5);
  EXPECT_FALSE(errors.ate_m);
  EXPECT_FALSE(errors.velocity_mps);
}

TEST(APartialCsv, WithoutAHeadingHasRollAndPitch) {
  const auto errors =
      errors_against_truth(csv("roll_deg,pitch_deg", [](int t) { return t < 10 ? "5,-3" : "5,"; }));
  EXPECT_NEAR(errors.roll_deg->max, 0, 1e-9);
  EXPECT_FALSE(errors.attitude_deg) << "the turn needs all three";
  EXPECT_FALSE(errors.heading_deg);
  EXPECT_THAT(errors.told, ElementsAre(0, 0, 0, 21, 10, 0, 0, 0, 0)) << "empty cells tell nothing";
}

TEST(APartialCsv, MayHaveAQuaternion) {
  // A half angle of 46 degrees about down: 2 degrees past east.
  std::ostringstream q;
  q.precision(17);
  q << std::cos(46 * degree) << ",0,0," << std::sin(46 * degree);
  const auto errors = errors_against_truth(csv("qw,qx,qy,qz", [&](int) { return q.str(); }));
  EXPECT_NEAR(errors.heading_deg->rms, 2, 1e-9);
  EXPECT_NEAR(errors.roll_deg->rms, 5, 1e-9);
  EXPECT_NEAR(errors.pitch_deg->rms, 3, 1e-9);
}

TEST(APartialCsv, OfAVelocityAloneIsScored) {
  const auto errors = errors_against_truth(
      csv("velocity_north_mps,velocity_east_mps,velocity_north_sigma_mps,velocity_east_sigma_mps",
          [](int) { return "0.3,2.4,0.1,0.2"; }));
  EXPECT_NEAR(errors.velocity_mps->rms, 0.5, 1e-12);
  EXPECT_NEAR(*errors.velocity_nees.mean, (9 + 4) / 2., 1e-9);
  EXPECT_THAT(errors.told, ElementsAre(0, 0, 0, 0, 0, 0, 21, 21, 0));
  const auto ahead = errors_against_truth(csv("body_forward_mps", [](int) { return "2.5"; }));
  EXPECT_NEAR(ahead.velocity_mps->rms, 2.5 - 2 * std::cos(3 * degree), 1e-12)
      << "pitched, the way is not all ahead";
}

TEST(APartialCsv, WithATimeAloneIsRefusedWithWhatItMayHave) {
  std::istringstream in("t_s,speed\n1,2\n");
  EXPECT_THAT(read_csv(in, "a.csv", origin).error().line,
              HasSubstr("roll_deg, pitch_deg, heading_deg, qw, qx, qy, qz, velocity_north_mps"));
}

TEST(AnAlignment, OfEstimatesWithoutAPlaceMovesNothingAndSaysSo) {
  Track angles = truth();
  for (State& state : angles) state.position_ned = untold();
  auto pairs = pairs_of(angles, truth(), std::chrono::seconds{2});
  EXPECT_THAT(align(pairs.all, Alignment::yaw), HasSubstr("moved nothing"));
}

}  // namespace drydock::score::partial_test
