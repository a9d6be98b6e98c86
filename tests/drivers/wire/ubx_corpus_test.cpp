#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "drivers/wire/ubx_nmea.hpp"
#include "tests/drivers/wire/gpsd_logs.hpp"

namespace drydock::wire::testing {
namespace {

class UbxCorpus : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(corpora())) GTEST_SKIP() << "no captures at " << corpora();
  }
};

TEST_F(UbxCorpus, EverySoundMessageOfGpsdsLogsIsDecoded) {
  std::map<std::string_view, std::size_t> count;
  std::size_t frames = 0;
  for (const auto& log : gpsd_logs()) {
    const auto reading = read_stream<Ubx>(gpsd_log(log));
    frames += reading.counters.frames;
    for (const auto& message : reading.messages) {
      ++count[std::visit([](const auto& m) { return m.type; }, message)];
    }
  }
  // Counted by a scanner in another language.
  const std::map<std::string_view, std::size_t> expected{
      {"NAV-PVT", 436}, {"NAV-SAT", 524}, {"NAV-EOE", 335}};
  EXPECT_EQ(count, expected);
  EXPECT_EQ(frames, 7578u);
}

TEST_F(UbxCorpus, BothProtocolsOnOneLineLoseNothingToEachOther) {
  for (const auto& folder : {gpsd_folder(), corpora() / "gps/pyubx2"}) {
    for (const auto& entry : std::filesystem::directory_iterator{folder}) {
      if (entry.path().extension() != ".log") continue;
      const Buffer bytes = gpsd_log(entry.path());
      EXPECT_EQ(
          read_stream<UbxNmea>(bytes).messages.size(),
          read_stream<Ubx>(bytes).messages.size() + read_stream<Nmea0183>(bytes).messages.size())
          << entry.path();
    }
  }
}

/// gnssid, svid, C/N0, elevation, azimuth, used: as gpsd prints them.
using Sky = std::set<std::tuple<int, int, int, int, int, bool>>;

constexpr int unknown = -999;

int rounded(const std::optional<double>& value) {
  return value ? static_cast<int>(std::lround(*value)) : unknown;
}

/// gpsd leaves out satellites without a direction, and prints 0 where nothing is tracked.
Sky sky_of(const NavSat& m) {
  Sky sky;
  for (const UbxSatellite& s : m.satellites) {
    if (!s.elevation_rad || !s.azimuth_rad) continue;
    sky.emplace(static_cast<int>(s.gnss), s.number, rounded(s.cno_dbhz.value_or(0)),
                rounded(degrees(s.elevation_rad)), rounded(degrees(s.azimuth_rad)), s.used);
  }
  return sky;
}

Sky sky_of(const nlohmann::json& report) {
  Sky sky;
  for (const auto& s : report.value("satellites", nlohmann::json::array())) {
    if (!s.contains("el") || !s.contains("az") || !s.contains("gnssid")) continue;
    sky.emplace(s["gnssid"], s["svid"], rounded(s.value("ss", 0.0)), rounded(s["el"].get<double>()),
                rounded(s["az"].get<double>()), s["used"]);
  }
  return sky;
}

TEST_F(UbxCorpus, SatellitesAreThoseThatGpsdReports) {
  std::size_t epochs = 0, reported = 0;
  for (const auto& log : gpsd_logs()) {
    const auto messages = read_stream<Ubx>(gpsd_log(log)).all<NavSat>();
    if (messages.empty()) continue;
    std::set<Sky> known;
    for (const auto& report : gpsd_reports(log, "SKY")) known.insert(sky_of(report));
    if (known.empty()) continue;
    epochs += messages.size();
    for (const NavSat& m : messages) reported += known.contains(sky_of(m));
  }
  EXPECT_EQ(epochs, 524u);
  EXPECT_EQ(reported, epochs);
}

TEST_F(UbxCorpus, PositionsAreThoseThatGpsdReports) {
  std::size_t positions = 0, reported = 0;
  for (const auto& log : gpsd_logs()) {
    std::set<std::pair<long, long>> known;
    for (const auto& tpv : gpsd_reports(log, "TPV")) {
      if (!tpv.contains("lat") || !tpv.contains("lon")) continue;
      known.emplace(std::lround(tpv["lat"].get<double>() * 1e7),
                    std::lround(tpv["lon"].get<double>() * 1e7));
    }
    if (known.empty()) continue;
    for (const NavPvt& m : read_stream<Ubx>(gpsd_log(log)).all<NavPvt>()) {
      if (!m.latitude_rad) continue;
      ++positions;
      reported += known.contains({std::lround(degrees(*m.latitude_rad) * 1e7),
                                  std::lround(degrees(*m.longitude_rad) * 1e7)});
    }
  }
  EXPECT_EQ(positions, 99u) << "counted by a scanner in another language";
  EXPECT_GE(reported, 90u) << "the others: gpsd drops a log's last epoch and merges mixed logs";
}

}  // namespace
}  // namespace drydock::wire::testing
