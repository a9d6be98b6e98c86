#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "drivers/wire/ubx/ubx_nmea.hpp"
#include "tests/drivers/wire/gpsd_logs.hpp"

namespace drydock::wire::testing {
namespace ubx_corpus_test {

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
  // These counts come from a scanner in another language.
  const std::map<std::string_view, std::size_t> expected{
      {"NAV-PVT", 436},     {"NAV-SAT", 524},     {"NAV-EOE", 335},    {"NAV-SIG", 300},
      {"NAV-DOP", 670},     {"NAV-SOL", 119},     {"NAV-STATUS", 153}, {"NAV-POSLLH", 151},
      {"NAV-TIMEGPS", 693}, {"NAV-TIMEUTC", 153}, {"NAV-SVINFO", 93},  {"RXM-SFRBX", 804}};
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

TEST_F(UbxCorpus, EveryMessageOfPyubx2sLogsIsDecoded) {
  std::map<std::string_view, std::size_t> count;
  for (const auto& entry : std::filesystem::directory_iterator{corpora() / "gps/pyubx2"}) {
    if (entry.path().extension() != ".log") continue;
    for (const auto& message : read_stream<Ubx>(read_file(entry.path())).messages) {
      ++count[std::visit([](const auto& m) { return m.type; }, message)];
    }
  }
  const std::map<std::string_view, std::size_t> expected{
      {"NAV-PVT", 10},   {"NAV-SAT", 4},     {"NAV-EOE", 3},     {"NAV-SIG", 2},
      {"NAV-DOP", 4},    {"NAV-SOL", 2},     {"NAV-STATUS", 4},  {"NAV-POSLLH", 4},
      {"NAV-VELNED", 4}, {"NAV-TIMEGPS", 3}, {"NAV-TIMEUTC", 4}, {"NAV-SVINFO", 1},
      {"RXM-RAWX", 14},  {"RXM-SFRBX", 1}};
  EXPECT_EQ(count, expected);
}

/// gnssid, svid, C/N0, elevation, azimuth, used, as gpsd prints them.
using Sky = std::set<std::tuple<int, int, int, int, int, bool>>;

constexpr int unknown = -999;

int rounded(const std::optional<double>& value) {
  return value ? static_cast<int>(std::lround(*value)) : unknown;
}

/// gpsd omits satellites without a direction, and prints 0 if nothing is tracked.
template <class SkyMessage>
Sky sky_of(const SkyMessage& m) {
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

/// The number of messages of this kind in gpsd's logs, and of those whose satellites gpsd all
/// reports.
template <class SkyMessage>
std::pair<std::size_t, std::size_t> epochs_and_reported() {
  std::size_t epochs = 0, reported = 0;
  for (const auto& log : gpsd_logs()) {
    const auto messages = read_stream<Ubx>(gpsd_log(log)).all<SkyMessage>();
    if (messages.empty()) continue;
    std::set<Sky> known;
    for (const auto& report : gpsd_reports(log, "SKY")) known.insert(sky_of(report));
    if (known.empty()) continue;
    epochs += messages.size();
    for (const SkyMessage& m : messages) reported += known.contains(sky_of(m));
  }
  return {epochs, reported};
}

TEST_F(UbxCorpus, SatellitesAreThoseThatGpsdReports) {
  EXPECT_EQ(epochs_and_reported<NavSat>(), std::pair(std::size_t{524}, std::size_t{524}));
}

TEST_F(UbxCorpus, SatellitesByChannelAreThoseThatGpsdReports) {
  EXPECT_EQ(epochs_and_reported<NavSvinfo>(), std::pair(std::size_t{93}, std::size_t{93}));
}

/// Satellite, GLONASS frequency, C/N0, quality. "used" is missing: for a signal gpsd derives it
/// from the quality (4 and better), not from the receiver's flags.
using Signals = std::set<std::tuple<int, int, int, int, int>>;

TEST_F(UbxCorpus, SignalsAreThoseThatGpsdReports) {
  const auto log = gpsd_folder() / "ublox-glo.log";
  std::set<Signals> known;
  for (const auto& report : gpsd_reports(log, "SKY")) {
    Signals signals;
    for (const auto& s : report.value("satellites", nlohmann::json::array())) {
      if (!s.contains("freqid")) continue;
      signals.emplace(s["gnssid"], s["svid"], s["freqid"].get<int>() - 7, s["ss"], s["qual"]);
    }
    known.insert(signals);
  }
  std::size_t epochs = 0;
  for (const NavSig& m : read_stream<Ubx>(gpsd_log(log)).all<NavSig>()) {
    Signals signals;
    for (const UbxSignal& s : m.signals) {
      signals.emplace(static_cast<int>(s.gnss), s.number, s.frequency_number.value_or(unknown),
                      rounded(s.cno_dbhz.value_or(0)), s.quality);
    }
    ++epochs;
    EXPECT_TRUE(known.contains(signals)) << m.itow.count();
  }
  EXPECT_EQ(epochs, 300u);
}

TEST_F(UbxCorpus, AReceiversSignalsAndSatellitesAgreeOnWhatIsUsed) {
  std::map<long, std::set<int>> used;
  const auto reading = read_stream<Ubx>(gpsd_log(gpsd_folder() / "ublox-glo.log"));
  for (const NavSat& m : reading.all<NavSat>()) {
    auto& numbers = used[m.itow.count()];
    for (const auto& s : m.satellites) {
      if (s.used) numbers.insert(s.number);
    }
  }
  for (const NavSig& m : reading.all<NavSig>()) {
    std::set<int> numbers;
    for (const auto& s : m.signals) {
      if (s.pseudorange_used) numbers.insert(s.number);
    }
    EXPECT_EQ(numbers, used.at(m.itow.count())) << m.itow.count();
  }
}

/// The second word of a GPS subframe has a count in units of six seconds and the number of the
/// subframe (IS-GPS-200, 20.3.3.2). Words include their parity in the low six bits.
TEST_F(UbxCorpus, SubframesAreThoseThatGpsdReports) {
  const auto log = gpsd_folder() / "ublox-ned-m8t-sbfrx3.log";
  std::vector<std::tuple<int, int, int>> expected, found;  // satellite, time of week, subframe
  for (const auto& report : gpsd_reports(log, "SUBFRAME")) {
    expected.emplace_back(report["tSV"], report["TOW17"], report["frame"]);
  }
  for (const RxmSfrbx& m : read_stream<Ubx>(gpsd_log(log)).all<RxmSfrbx>()) {
    ASSERT_EQ(m.words.size(), 10u);
    EXPECT_EQ(m.words[0] >> 22, 0x8Bu) << "preamble";
    found.emplace_back(m.number, (m.words[1] >> 13 & 0x1FFFF) * 6, m.words[1] >> 8 & 7);
  }
  EXPECT_EQ(found.size(), 165u);
  EXPECT_EQ(expected.size(), 151u) << "gpsd has no report for some pages";
  EXPECT_TRUE(std::ranges::includes(found, expected)) << "in the order of their time";
}

/// gpsd's position in ECEF is that of NAV-SOL.
TEST_F(UbxCorpus, EcefPositionsAreThoseThatGpsdReports) {
  std::size_t positions = 0, reported = 0;
  for (const auto& log : gpsd_logs()) {
    std::set<std::array<long, 3>> known;  // centimetres
    const auto centimetres = [](double metres) { return std::lround(metres * 100); };
    for (const auto& tpv : gpsd_reports(log, "TPV")) {
      if (!tpv.contains("ecefx")) continue;
      known.insert(
          {centimetres(tpv["ecefx"]), centimetres(tpv["ecefy"]), centimetres(tpv["ecefz"])});
    }
    if (known.empty()) continue;
    for (const NavSol& m : read_stream<Ubx>(gpsd_log(log)).all<NavSol>()) {
      if (!m.position_ecef_m[0]) continue;
      ++positions;
      reported +=
          known.contains({centimetres(*m.position_ecef_m[0]), centimetres(*m.position_ecef_m[1]),
                          centimetres(*m.position_ecef_m[2])});
    }
  }
  EXPECT_GE(positions, 54u);
  EXPECT_GE(reported + 2, positions) << "gpsd merges the two seconds in which the fix was lost";
}

TEST_F(UbxCorpus, PositionsOfATimingReceiverAreThoseThatGpsdReports) {
  const auto messages = read_stream<Ubx>(gpsd_log(gpsd_folder() / "u-blox-m8t-time.log"));
  ASSERT_EQ(messages.all<NavPosllh>().size(), 151u);
  for (const NavPosllh& m : messages.all<NavPosllh>()) {
    EXPECT_NEAR(degrees(*m.latitude_rad), 44.7654405, 1e-9);  // every TPV of the report has it
    EXPECT_NEAR(degrees(*m.longitude_rad), -68.8066651, 1e-9);
    EXPECT_DOUBLE_EQ(*m.ellipsoidal_height_m, 13.684);
  }
  for (const NavStatus& m : messages.all<NavStatus>()) {
    EXPECT_EQ(m.fix_type, UbxFixType::time_only);
  }
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

}  // namespace ubx_corpus_test
}  // namespace drydock::wire::testing
