#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "tests/drivers/device/gnss_receiver.hpp"

/// Feeds every log of gpsd through the whole driver. It checks that each epoch comes once, and
/// compares the satellites with gpsd's report.
namespace drydock::device::test {
namespace gnss_corpus_test {

using measurement::GnssFix;
using measurement::GnssSatellites;

Octets behind_head(Octets bytes) {
  auto at = bytes.begin();
  while (at != bytes.end() && *at == '#') at = std::find(at, bytes.end(), '\n') + 1;
  bytes.erase(bytes.begin(), at);
  return bytes;
}

/// Feeds the log in blocks of 64 bytes, one each millisecond: a line without any pause.
Ear heard(const std::filesystem::path& log) {
  const Octets capture = behind_head(read_all(log));
  Ear ear;
  const auto driver = byte_driver(options(Kind::gnss, "ubx+nmea0183"));
  double now = 1;
  for (std::size_t at = 0; at < capture.size(); at += 64) {
    const std::size_t n = std::min<std::size_t>(64, capture.size() - at);
    driver->receive({capture.data() + at, n}, at_s(now += 0.001), ear);
  }
  driver->tick(at_s(now + 10), ear);
  return ear;
}

bool carries(const std::filesystem::path& log, std::string_view bytes) {
  const Octets capture = behind_head(read_all(log));
  return std::string_view{reinterpret_cast<const char*>(capture.data()), capture.size()}.find(
             bytes) != std::string_view::npos;
}

class GnssCorpus : public testing::Test {
 protected:
  void SetUp() override {
    if (!exists(folder)) GTEST_SKIP() << "no gpsd captures in " << folder;
    for (const auto& entry : std::filesystem::directory_iterator{folder}) {
      if (entry.path().extension() == ".log") logs.push_back(entry.path());
    }
    std::ranges::sort(logs);
  }
  const std::filesystem::path folder = corpora() / "gps/gpsd/daemon";
  std::vector<std::filesystem::path> logs;
};

TEST_F(GnssCorpus, NoEpochComesTwice) {
  std::size_t fixes = 0;
  for (const auto& log : logs) {
    const GnssFix* before = nullptr;
    const auto all = heard(log).all<GnssFix>();
    for (const GnssFix& fix : all) {
      ++fixes;
      if (before && fix.origin.device_time) {
        EXPECT_NE(fix.origin.device_time, before->origin.device_time) << log;
      }
      before = &fix;
    }
  }
  EXPECT_GT(fixes, 2000U);
}

/// For each satellite: C/N0, elevation, azimuth, used. gpsd lists every signal; the driver lists
/// the strongest of a satellite. Both sides omit satellites without a direction.
using Sky = std::map<std::pair<int, int>, std::tuple<int, int, int, bool>>;

int whole(const std::optional<double>& value) {
  return static_cast<int>(std::lround(value.value_or(0)));
}

Sky sky_of(const GnssSatellites& m) {
  Sky sky;
  for (const auto& s : m.satellites) {
    if (!s.elevation_rad || !s.azimuth_rad) continue;
    sky[{static_cast<int>(s.constellation), s.number}] = {whole(s.cno_dbhz),
                                                          whole(*s.elevation_rad / degree),
                                                          whole(*s.azimuth_rad / degree), s.used};
  }
  return sky;
}

Sky sky_of(const nlohmann::json& report) {
  Sky sky;
  for (const auto& s : report.value("satellites", nlohmann::json::array())) {
    if (!s.contains("el") || !s.contains("az") || !s.contains("gnssid")) continue;
    const auto [place, is_new] = sky.try_emplace({s["gnssid"], s["svid"]});
    auto& [cno, elevation, azimuth, used] = place->second;
    cno = std::max(is_new ? 0 : cno, whole(s.value("ss", 0.0)));
    elevation = whole(s["el"].get<double>());
    azimuth = whole(s["az"].get<double>());
    used = s["used"].get<bool>() || (!is_new && used);
  }
  return sky;
}

struct Agreement {
  std::size_t skies = 0, reported = 0;
};

Agreement agreement(const std::filesystem::path& log) {
  std::set<Sky> known;
  std::ifstream reports(log.string() + ".chk");
  for (std::string line; std::getline(reports, line);) {
    if (line.starts_with("{\"class\":\"SKY\"")) known.insert(sky_of(nlohmann::json::parse(line)));
  }
  Agreement result;
  for (const auto& m : heard(log).all<GnssSatellites>()) {
    const Sky sky = sky_of(m);
    if (sky.empty()) continue;
    ++result.skies;
    result.reported += known.contains(sky);
  }
  return result;
}

TEST_F(GnssCorpus, SatellitesAreThoseThatGpsdReports) {
  Agreement ubx, nmea;
  for (const auto& log : logs) {
    const Agreement found = agreement(log);
    if (found.skies == 0) continue;
    const bool speaks_ubx = carries(log, "\xB5\x62");
    if (speaks_ubx && carries(log, "GSV,")) continue;  // gpsd merges both protocols
    Agreement& sum = speaks_ubx ? ubx : nmea;
    sum.skies += found.skies;
    sum.reported += found.reported;
  }
  EXPECT_EQ(ubx.reported, ubx.skies);
  EXPECT_GT(ubx.skies, 400U);
  // In the others gpsd keeps the used satellites of an earlier epoch, does not call a satellite
  // without C/N0 used, or reports before all constellations have come.
  EXPECT_GE(nmea.reported, 736U) << "of " << nmea.skies;
}

}  // namespace gnss_corpus_test
}  // namespace drydock::device::test
