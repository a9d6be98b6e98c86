// The track of a real AUV's dive, from its DVL's capture alone. The reference is the vehicle's own
// navigation, nav.csv.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "drivers/measurement/units.hpp"
#include "hil/track/track.hpp"

namespace drydock::track::auv_track_test {
namespace {

namespace fs = std::filesystem;

fs::path corpora() {
  const char* named = std::getenv("DRYDOCK_CORPORA");
  return named != nullptr ? named : DRYDOCK_SOURCE_DIR "/../shared/corpora";
}

struct Depth {
  double time_s = 0, m = 0;
};

/// By the vehicle, each two seconds; times of the DVL's clock.
std::vector<Depth> depths() {
  std::ifstream file(corpora() / "dives/remus_20141219_a/nav.csv");
  std::string line;
  std::getline(file, line);
  std::vector<Depth> depths;
  while (std::getline(file, line)) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream words(line);
    double ensemble = 0, latitude = 0, longitude = 0, speed = 0, heading = 0;
    Depth depth;
    words >> depth.time_s >> ensemble >> latitude >> longitude >> speed >> heading >> depth.m;
    depths.push_back(depth);
  }
  return depths;
}

TEST(AuvTrack, HasTheDepthsThatTheHeadTold) {
  const auto dive = corpora() / "dvl/pd0/raw/remus_20141219_a.adc";
  if (!fs::exists(dive)) GTEST_SKIP() << "no dive at " << dive;
  TrackOptions options;
  options.source.capture = dive.string();
  options.source.protocol = "pd0";
  auto gathered = gather(options);
  EXPECT_TRUE(gathered.own_depth);
  const double start_s = measurement::seconds(gathered.start.time_since_epoch());
  const auto outcome =
      smoothed(std::move(gathered), Model::best,
               frame::Position{41.554 * units::degree, -70.705 * units::degree, 0});
  EXPECT_TRUE(outcome.has_heights);
  const auto reference = depths();
  std::size_t compared = 0, close = 0;
  for (const auto& point : outcome.track.smoothed) {
    const auto at =
        std::ranges::lower_bound(reference, start_s + point.time_s - 0.02, {}, &Depth::time_s);
    if (at == reference.end() || std::abs(at->time_s - start_s - point.time_s) > 0.02) continue;
    ++compared;
    if (std::abs(-point.position.height_m - at->m) < 0.5) ++close;
  }
  ASSERT_GT(compared, 1900u);
  // Not beside the pause of 79 minutes, where nobody knows how it dived.
  EXPECT_GT(static_cast<double>(close), 0.99 * static_cast<double>(compared));
}

}  // namespace
}  // namespace drydock::track::auv_track_test
