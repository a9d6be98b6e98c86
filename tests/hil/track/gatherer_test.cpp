#include "hil/track/gatherer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace drydock::track::gatherer_test {
namespace {

using namespace measurement;
using smoothing::Quantity;

constexpr double degree = std::numbers::pi / 180, pitch = -29 * degree, bow = 20 * degree;
enum : std::uint16_t { dvl, compass };

/// A DVL whose bow axis stands 45 degrees to starboard, and a compass.
rig_config::Rig rig() {
  rig_config::Rig rig;
  rig.devices.resize(2);
  rig.devices[dvl].kind = Kind::dvl;
  rig.devices[dvl].mounting_rad = {0, 0, 45 * degree};
  rig.devices[compass].kind = Kind::attitude;
  return rig;
}

Origin origin(double t, std::uint16_t device) {
  Origin origin;
  origin.valid_at = origin.received_at = Stamp{} + from_seconds(t);
  origin.device = device;
  return origin;
}

/// Of a vehicle whose bow points to 20 degrees, 29 degrees down: each tilt sensor reads the part of
/// gravity along its axis against that along the head's third axis.
BottomVelocity head(double t, bool with_tilts = true) {
  BottomVelocity track;
  track.origin = origin(t, dvl);
  track.velocity = Eigen::Vector3d{1, 0, 0};
  track.heading_rad = bow + std::atan(1 / std::cos(pitch));
  if (!with_tilts) return track;
  track.roll_rad = track.pitch_rad = std::atan(std::tan(pitch) * std::sqrt(0.5));
  return track;
}

AttitudeSample compass_sample(double t, std::optional<double> heading, std::optional<double> tilt) {
  AttitudeSample sample;
  sample.origin = origin(t, compass);
  sample.true_heading_rad = heading;
  if (tilt) sample.roll_rad = 0;
  sample.pitch_rad = tilt;
  return sample;
}

std::vector<smoothing::Reading> headings_of(const Gathered& gathered) {
  std::vector<smoothing::Reading> headings;
  for (const auto& reading : gathered.dive.readings)
    if (reading.quantity == Quantity::heading) headings.push_back(reading);
  return headings;
}

class OneDive : public testing::Test {
 protected:
  const rig_config::Rig rig_ = rig();
  Gatherer gatherer_{rig_, {}};
};

TEST_F(OneDive, BesideACompassThatTellsNoTiltsThoseOfTheDvlCount) {
  for (int t = 0; t < 20; ++t) {
    gatherer_.on_measurement(head(t));
    gatherer_.on_measurement(compass_sample(t, bow, {}));
  }
  const auto gathered = gatherer_.take();
  ASSERT_EQ(gathered.dive.tilts.size(), 20U);
  EXPECT_NEAR(gathered.dive.tilts[7].roll_rad, 0, 1e-12);
  EXPECT_NEAR(gathered.dive.tilts[7].pitch_rad, pitch, 1e-12);
  EXPECT_TRUE(gathered.own_tilts);
  EXPECT_FALSE(gathered.own_heading);
  for (const auto& heading : headings_of(gathered)) EXPECT_EQ(heading.device, compass);
}

TEST_F(OneDive, WithoutAHeadingOfACompassTheDvlsCounts) {
  for (int t = 0; t < 20; ++t) gatherer_.on_measurement(head(t));
  const auto gathered = gatherer_.take();
  EXPECT_TRUE(gathered.own_heading);
  ASSERT_EQ(headings_of(gathered).size(), 20U);
  EXPECT_NEAR(headings_of(gathered)[7].value.x(), bow, 1e-12);
}

TEST_F(OneDive, AHeadWithoutTiltsIsTurnedByThoseOfAnotherDevice) {
  for (int t = 0; t < 20; ++t) {
    gatherer_.on_measurement(head(t, false));
    gatherer_.on_measurement(compass_sample(t, {}, pitch));
  }
  const auto gathered = gatherer_.take();
  EXPECT_FALSE(gathered.own_tilts);
  ASSERT_EQ(headings_of(gathered).size(), 20U);
  EXPECT_NEAR(headings_of(gathered)[7].value.x(), bow, 1e-12);
}

TEST_F(OneDive, ACompassThatFellSilentLeavesTheTiltsToTheDvl) {
  for (int t = 0; t < 100; ++t) {
    gatherer_.on_measurement(head(t));
    if (t < 30)
      for (int k = 0; k < 9; ++k) gatherer_.on_measurement(compass_sample(t + 0.1 * k, bow, pitch));
  }
  const auto gathered = gatherer_.take();
  EXPECT_TRUE(gathered.own_tilts);
  EXPECT_EQ(gathered.dive.tilts.size(), 100U);
}

TEST_F(OneDive, ASlowCompassCountsBeforeAFastHead) {
  for (int t = 0; t < 100; ++t) {
    gatherer_.on_measurement(head(t));
    if (t % 4 == 0) gatherer_.on_measurement(compass_sample(t, bow, pitch));
  }
  EXPECT_FALSE(gatherer_.take().own_tilts);
}

std::vector<double> depths_of(const Gathered& gathered) {
  std::vector<double> depths;
  for (const auto& reading : gathered.dive.readings)
    if (reading.quantity == Quantity::depth) depths.push_back(reading.value.x());
  return depths;
}

BottomVelocity head_at_depth(double t, double depth_m) {
  auto track = head(t);
  track.depth_m = depth_m;
  return track;
}

TEST_F(OneDive, WithoutADepthSensorTheDepthOfTheHeadCounts) {
  for (int t = 0; t < 3; ++t) gatherer_.on_measurement(head_at_depth(t, 4 + 0.5 * t));
  const auto gathered = gatherer_.take();
  EXPECT_TRUE(gathered.own_depth);
  EXPECT_EQ(depths_of(gathered), (std::vector{4.0, 4.5, 5.0}));
}

TEST_F(OneDive, ADepthOfTheHeadThatNeverChangesIsASetting) {
  for (int t = 0; t < 3; ++t) gatherer_.on_measurement(head_at_depth(t, 2));
  const auto gathered = gatherer_.take();
  EXPECT_FALSE(gathered.own_depth);
  EXPECT_TRUE(depths_of(gathered).empty());
}

TEST_F(OneDive, BesideADepthSensorTheHeadsDepthDoesNotCount) {
  for (int t = 0; t < 3; ++t) gatherer_.on_measurement(head_at_depth(t, 4 + t));
  DepthSample sample;
  sample.origin = origin(1, compass);
  sample.depth_m = 7;
  gatherer_.on_measurement(sample);
  const auto gathered = gatherer_.take();
  EXPECT_FALSE(gathered.own_depth);
  EXPECT_EQ(depths_of(gathered), std::vector{7.0});
}

}  // namespace
}  // namespace drydock::track::gatherer_test
