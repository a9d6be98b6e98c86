#include <gtest/gtest.h>

#include "drivers/bus/cdr/cdr_measurements.hpp"
#include "drivers/recordings/record/recording.hpp"

/// fixtures/recording/NOTES.md: a recording of an older version. The values are those that the
/// older version exported.
namespace drydock::record {
namespace older_recording_test {

using namespace measurement;

template <class Sample>
std::vector<Sample> read_all() {
  auto recording =
      Recording::open(DRYDOCK_SOURCE_DIR "/fixtures/recording/before-accuracies.mcap").value();
  bus::CdrMeasurements decoder;
  std::vector<Sample> found;
  while (const auto event = recording.next()) {
    const auto* message = std::get_if<Understood>(&*event);
    if (message == nullptr) continue;
    const auto topic = bus::measurement_topic(message->channel->topic, message->schema->name);
    if (!topic) continue;
    const auto measurement = decoder.read(topic->kind, message->cdr, message->at);
    EXPECT_TRUE(measurement) << message->channel->topic;
    if (measurement && std::holds_alternative<Sample>(*measurement))
      found.push_back(std::get<Sample>(*measurement));
  }
  return found;
}

TEST(OlderRecording, VelocitiesOverTheBedHaveNoAccuracy) {
  const auto all = read_all<BottomVelocity>();
  ASSERT_EQ(all.size(), 8U);
  EXPECT_EQ(all[0].velocity, Eigen::Vector3d(2.5, 0, 0));
  EXPECT_EQ(all[0].altitude_m, 20);
  for (const auto& sample : all)
    EXPECT_FALSE(sample.velocity_covariance || sample.figure_of_merit_mps);
}

TEST(OlderRecording, SpeedsThroughTheWaterHaveNoSigma) {
  const auto all = read_all<WaterSpeed>();
  ASSERT_EQ(all.size(), 8U);
  EXPECT_EQ(all[0].longitudinal_mps, 2.5002000000000004);
  for (const auto& sample : all) EXPECT_FALSE(sample.sigma_mps);
}

TEST(OlderRecording, FixesDoNotTellTheirQuality) {
  const auto all = read_all<GnssFix>();
  ASSERT_EQ(all.size(), 4U);
  ASSERT_TRUE(all[0].position);
  EXPECT_EQ(all[0].position->latitude_rad, 0.6283185307179586);
  EXPECT_EQ(all[0].course_rad, 0.5235987755982988);
  EXPECT_EQ(all[0].satellites_used, 9);
  for (const auto& fix : all) EXPECT_FALSE(fix.quality);
}

/// The later fields are added only to a whole message of the older form.
TEST(OlderRecording, AMessageThatEndsEarlyIsStillRefused) {
  auto recording =
      Recording::open(DRYDOCK_SOURCE_DIR "/fixtures/recording/before-accuracies.mcap").value();
  bus::CdrMeasurements decoder;
  while (const auto event = recording.next()) {
    const auto* message = std::get_if<Understood>(&*event);
    if (message == nullptr || message->channel->topic != "/dvl/bottom_track") continue;
    for (std::size_t n = 0; n < message->cdr.size(); ++n)
      ASSERT_FALSE(decoder.read(bus::Kind::dvl, message->cdr.first(n), message->at)) << n;
    return;
  }
  FAIL() << "no bottom track";
}

}  // namespace older_recording_test
}  // namespace drydock::record
