// Dead reckoning over a real AUV's dive, from the bytes of its DVL. The reference is the vehicle's
// own navigation: it reckons with the same DVL, but it is set right by position fixes and so jumps.
// So each leg between two jumps is reckoned from its begin.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <sstream>

#include "drivers/device/make_driver.hpp"
#include "drivers/measurement/sound_speed_used.hpp"
#include "estimators/pipeline/reckoning/dead_reckoning_estimator.hpp"

namespace drydock::pipeline::auv_dive_test {
namespace {

using measurement::Stamp;

constexpr double degree = std::numbers::pi / 180;

std::filesystem::path corpora() {
  const char* named = std::getenv("DRYDOCK_CORPORA");
  return named ? named : DRYDOCK_SOURCE_DIR "/../shared/corpora";
}

/// The DVL's measurements at the times of its own clock.
struct Heard final : device::Output {
  void publish(const measurement::Measurement& measurement) override {
    auto track = std::get<measurement::BottomVelocity>(measurement);
    track.origin.valid_at = Stamp{track.origin.device_time.value()};
    tracks.push_back(track);
  }
  void send(wire::Bytes) override {}
  void send(const wire::CanFrame&) override {}
  std::vector<measurement::BottomVelocity> tracks;
};

/// The data are not levelled, though the wire says so. The water had 1469.9 m/s (Mackenzie), the
/// head was set to 1500.
std::vector<measurement::BottomVelocity> dive(
    const device::SoundSpeedOptions& sound = {.source = device::SoundSpeedOptions::Source::fixed,
                                              .fixed_mps = 1469.9}) {
  device::DriverOptions options;
  options.kind = device::Kind::dvl;
  options.protocol = "pd0";
  options.dvl.levelled = false;
  options.dvl.sound_speed = sound;
  const auto driver = *device::make_byte_driver(options);
  std::ifstream file(corpora() / "dvl/pd0/raw/remus_20141219_a.adc", std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  Heard heard;
  driver->receive({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, Stamp{},
                  heard);
  return heard.tracks;
}

struct Place {
  double time_s = 0, speed_mps = 0;
  frame::Position position;
};

std::vector<Place> navigation() {
  std::ifstream file(corpora() / "dives/remus_20141219_a/nav.csv");
  std::string line;
  std::getline(file, line);
  std::vector<Place> places;
  while (std::getline(file, line)) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream words(line);
    double ensemble = 0, latitude = 0, longitude = 0;
    Place place;
    words >> place.time_s >> ensemble >> latitude >> longitude >> place.speed_mps;
    place.position = {latitude * degree, longitude * degree, 0};
    places.push_back(place);
  }
  return places;
}

/// A step that is 8 m longer or shorter than the speed makes it is a jump; so is a pause of 10 s.
bool jumps(const Place& from, const Place& to) {
  const double dt = to.time_s - from.time_s;
  const double way = frame::ned_offset(from.position, to.position).head<2>().norm();
  return dt > 10 || std::abs(way - dt * (from.speed_mps + to.speed_mps) / 2) > 8;
}

struct Leg {
  double way_m = 0, worst_m = 0;
  double share() const { return worst_m / way_m; }
};

struct Track final : EstimateListener {
  void on_attitude(const AttitudeEstimate&) override {}
  void on_navigation(const NavigationEstimate& estimate) override { last = estimate; }
  std::optional<NavigationEstimate> last;
};

Leg reckoned(std::span<const measurement::BottomVelocity> tracks, std::span<const Place> places) {
  ReckoningOptions options;
  options.dvl = ReckoningDevice{};
  options.start = places.front().position;
  DeadReckoningEstimator estimator({}, options, {});
  Track track;
  Leg leg;
  frame::Position before = places.front().position;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (estimator.take(tracks[i], track) != Outcome::accepted) continue;
    if (estimator.status().estimates == 1) before = track.last->position;
    const auto& here = track.last->position;
    leg.way_m += frame::ned_offset(before, here).head<2>().norm();
    before = here;
    leg.worst_m =
        std::max(leg.worst_m, frame::ned_offset(places[i].position, here).head<2>().norm());
  }
  return leg;
}

std::vector<Leg> legs() {
  const auto tracks = dive();
  const auto places = navigation();
  EXPECT_EQ(tracks.size(), places.size());
  std::vector<Leg> legs;
  for (std::size_t begin = 0, i = 1; i <= places.size(); ++i) {
    if (i < places.size() && !jumps(places[i - 1], places[i])) continue;
    legs.push_back(reckoned(std::span(tracks).subspan(begin, i - begin),
                            std::span(places).subspan(begin, i - begin)));
    begin = i;
  }
  std::ranges::sort(legs, std::greater{}, &Leg::way_m);
  return legs;
}

/// The first half of the dive has five legs of more than 300 m, 3.7 km in all. By hand (Python, the
/// same definition of a leg): 0.33, 1.17, 0.49, 1.19 and 2.00 % of the way. Both halves have ten,
/// of which the median by hand is 1.03 %.
TEST(AuvDive, LegsBetweenJumpsOfItsNavigationAreReckonedToOnePercent) {
  if (!std::filesystem::exists(corpora())) GTEST_SKIP() << "no captures in " << corpora();
  auto all = legs();
  std::erase_if(all, [](const Leg& leg) { return leg.way_m < 300; });
  ASSERT_GE(all.size(), 5u);
  double way = 0, worst = 0;
  for (const Leg& leg : all) {
    way += leg.way_m;
    worst += leg.worst_m;
  }
  EXPECT_GT(way, 3600);
  EXPECT_LT(worst / way, 0.012);  // over the whole way
  std::ranges::sort(all, {}, &Leg::share);
  EXPECT_LT(all[all.size() / 2].share(), all.size() < 10 ? 0.012 : 0.011);
}

/// By hand (Python, Mackenzie, the whole dive) the water had 1469.9 m/s, and the vehicle's own
/// speed is 0.9804 of the DVL's.
TEST(AuvDive, ItsOwnSensorsTellThatTheHeadsSpeedOfSoundIsTwoPercentTooHigh) {
  if (!std::filesystem::exists(corpora())) GTEST_SKIP() << "no captures in " << corpora();
  measurement::SoundSpeedUsed sound;
  for (const auto& track : dive({})) sound.add(track);
  const auto means = sound.means();
  ASSERT_TRUE(means);
  EXPECT_EQ(means->used_mps, 1500);
  EXPECT_EQ(means->salinity_ppt, 31);
  EXPECT_NEAR(means->of_water_mps, 1469.9, 2);
  EXPECT_NEAR(means->error(), 0.0205, 0.0015);
}

}  // namespace
}  // namespace drydock::pipeline::auv_dive_test
