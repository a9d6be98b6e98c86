// The CSV of `drydock track` is read as anyone's: its times, its standard deviations.
#include <gmock/gmock.h>

#include <sstream>

#include "hil/track/formats.hpp"
#include "tests/hil/score/partial.hpp"

namespace drydock::score::track_csv_test {

using namespace partial_test;
using testing::IsEmpty;

/// Along the truth of partial.hpp, but 3 m north and 4 m east of it; 2 m and 1 m are sigmas, with
/// correlation 0.5.
std::string track_csv() {
  track::Outcome outcome;
  outcome.has_heights = true;
  for (int t = 0; t <= 20; ++t) {
    smoothing::TrackPoint point;
    point.time_s = t;
    point.position = frame::at_ned_offset(origin, {3, 2. * t + 4, 0});
    point.velocity_ned = {0, 2, 0};
    point.attitude = {true_angles.x(), true_angles.y(), true_angles.z()};
    point.position_covariance = Vector3d{4, 1, 9}.asDiagonal();
    point.position_covariance(0, 1) = point.position_covariance(1, 0) = 1;
    point.heading_sigma_rad = 1 * degree;
    outcome.track.smoothed.push_back(point);
  }
  return to_csv(outcome, outcome.track.smoothed);
}

TEST(ATrackAsCsv, IsScored) {
  std::istringstream in(track_csv());
  const auto read = read_csv(in, "dive.csv", origin);
  ASSERT_TRUE(read) << read.error().line;
  EXPECT_THAT(read->notes, IsEmpty());
  const auto errors = errors_against_truth(*read);
  EXPECT_NEAR(errors.ate_m->rms, 5, 1e-3);
  EXPECT_NEAR(*errors.vertical_rms_m, 0, 1e-3);
  EXPECT_NEAR(errors.velocity_mps->max, 0, 1e-5);
  EXPECT_NEAR(errors.heading_deg->max, 0, 1e-4);
  // (3 4) over ((4 1) (1 1)) is (9 - 2 * 12 + 4 * 16) / 3, of three axes.
  EXPECT_NEAR(*errors.position_nees.mean, 49. / 3 / 3, 0.01);
}

TEST(ATrackAsCsv, HasTimesOfAllMilliseconds) {
  std::istringstream in("utc,latitude_deg,longitude_deg\n2026-11-21T08:00:00.125Z,36,129\n");
  const auto read = read_csv(in, "dive.csv", origin);
  ASSERT_TRUE(read) << read.error().line;
  EXPECT_EQ(read->track.at(0).at, measurement::stamp_from_ns(1'795'248'000'125'000'000));
}

TEST(ATrackAsCsv, WithATimeThatIsNoneIsRefusedByItsLine) {
  std::istringstream in("utc,north_m\n2026-11-21 08:00,3\n");
  const auto read = read_csv(in, "dive.csv", origin);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().line, "dive.csv:2: utc = \"2026-11-21 08:00\" is no time");
}

}  // namespace drydock::score::track_csv_test
