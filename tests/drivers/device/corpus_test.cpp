#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/drivers/device/support.hpp"

/// Feeds real captures through whole drivers and compares with the results of other programs.
namespace drydock::device::test {
namespace corpus_test {

using measurement::BottomVelocity;
using measurement::GnssFix;
using measurement::GnssSatellites;

/// Feeds a capture in blocks of 64 bytes, as a port does.
Ear ear_after(Kind kind, const std::string& protocol, const Octets& capture) {
  Ear ear;
  const auto driver = byte_driver(options(kind, protocol));
  double now = 1;
  for (std::size_t at = 0; at < capture.size(); at += 64) {
    const std::size_t n = std::min<std::size_t>(64, capture.size() - at);
    driver->receive({capture.data() + at, n}, at_s(now += 0.001), ear);
  }
  driver->tick(at_s(now + 10), ear);
  const wire::StreamCounters& c = driver->counters();
  EXPECT_EQ(c.bytes_in, capture.size());
  EXPECT_EQ(c.bytes_in, c.bytes_good + c.bytes_skipped + driver->held_bytes());
  return ear;
}

/// The readings of MHKiT that a driver must give too: the first three components are sound.
bool has_bottom_track(const nlohmann::json& row) {
  const auto& v = row["vel_bt"];
  return v[0] > -32 && v[1] > -32 && v[2] > -32;
}

std::vector<nlohmann::json> json_lines(const std::filesystem::path& path) {
  std::vector<nlohmann::json> rows;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("{")) rows.push_back(nlohmann::json::parse(line, nullptr, false));
  }
  return rows;
}

TEST(Corpus, DvlDriverAgreesWithMhkitOnARiverTransect) {
  const auto folder = corpora() / "dvl/pd0";
  if (!exists(folder)) GTEST_SKIP() << "no PD0 captures in " << folder;
  const Ear ear = ear_after(Kind::dvl, "pd0", read_all(folder / "raw/winriver02.PD0"));
  const auto heard = ear.all<BottomVelocity>();
  const auto rows = json_lines(folder / "expected/winriver02.jsonl");
  ASSERT_EQ(rows.size(), 74U);
  ASSERT_GE(heard.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    // Ship axes without tilts: starboard, forward. The velocity is that of the bed, so its sign is
    // opposite.
    const double starboard = rows[i]["vel_bt"][0], forward = rows[i]["vel_bt"][1];
    if (starboard < -32 || forward < -32) continue;
    ASSERT_TRUE(heard[i].velocity) << i;
    const double expected = std::hypot(starboard, forward);
    EXPECT_NEAR(heard[i].velocity->norm(), std::hypot(expected, double(rows[i]["vel_bt"][2])),
                1e-3);
    EXPECT_NEAR(measurement::seconds(*heard[i].origin.device_time), double(rows[i]["time"]), 1e-2);
    EXPECT_NEAR(heard[i].range_m[0].value_or(0), double(rows[i]["dist_bt"][0]), 1e-4);
    EXPECT_NEAR(heard[i].sound_speed_mps.value(), double(rows[i]["c_sound"]), 1e-9);
  }
}

/// Positions of gpsd's fixes, rounded to 1e-7 degree.
std::vector<std::pair<double, double>> gpsd_positions(const std::filesystem::path& chk) {
  std::vector<std::pair<double, double>> found;
  for (const auto& row : json_lines(chk)) {
    if (row.value("class", "") == "TPV" && row.contains("lat")) {
      found.emplace_back(row["lat"], row["lon"]);
    }
  }
  return found;
}

void agrees_with_gpsd(const std::string& name, const std::string& protocol, double share) {
  const auto folder = corpora() / "gps/gpsd/daemon";
  if (!exists(folder)) GTEST_SKIP() << "no gpsd captures in " << folder;
  const Ear ear = ear_after(Kind::gnss, protocol, read_all(folder / (name + ".log")));
  const auto expected = gpsd_positions(folder / (name + ".log.chk"));
  std::size_t positions = 0, known = 0;
  for (const GnssFix& fix : ear.all<GnssFix>()) {
    if (!fix.position) continue;
    ++positions;
    const double lat = fix.position->latitude_rad / degree;
    const double lon = fix.position->longitude_rad / degree;
    known += std::ranges::any_of(expected, [&](const auto& p) {
      return std::abs(p.first - lat) < 2e-7 && std::abs(p.second - lon) < 2e-7;
    });
  }
  EXPECT_GT(positions, 0U);
  // gpsd omits the last epoch of a capture and merges others.
  EXPECT_GE(static_cast<double>(known), share * static_cast<double>(positions)) << positions;
}

TEST(Corpus, GnssDriverAgreesWithGpsdOnUbx) { agrees_with_gpsd("ublox-neo-m8n", "ubx", 0.7); }
TEST(Corpus, GnssDriverAgreesWithGpsdOnNmea) { agrees_with_gpsd("gpsdf", "nmea0183", 0.95); }
TEST(Corpus, GnssDriverAgreesWithGpsdOnNmeaOfSeveralConstellations) {
  agrees_with_gpsd("quectelLC79D", "nmea0183", 0.95);
}

TEST(Corpus, ReceiverWithoutFixGivesNoPosition) {
  const auto log = corpora() / "gps/gpsd/daemon/tn200.log";
  if (!exists(log)) GTEST_SKIP() << "no capture " << log;
  const Ear ear = ear_after(Kind::gnss, "nmea0183", read_all(log));
  EXPECT_FALSE(ear.all<GnssFix>().empty());
  for (const GnssFix& fix : ear.all<GnssFix>()) EXPECT_FALSE(fix.position);
}

TEST(Corpus, EmLogDriverHearsEveryWaterSpeedOfARealBoat) {
  const auto log = corpora() / "gps/gpsd/daemon/bundg_zeus_9.log";
  if (!exists(log)) GTEST_SKIP() << "no capture " << log;
  const Ear ear = ear_after(Kind::emlog, "nmea0183", read_all(log));
  std::size_t speeds = 0;
  for (const auto& m : ear.all<measurement::WaterSpeed>()) {
    if (!m.longitudinal_mps) continue;
    ++speeds;
    EXPECT_GT(*m.longitudinal_mps, 0);
    EXPECT_LT(*m.longitudinal_mps, 10);
  }
  EXPECT_EQ(speeds, 150U);  // counted in the text of the capture
}

TEST(Corpus, ImuDriverAgreesWithTheMakersDatabase) {
  const auto log = corpora() / "can_imu/aceinna_mtlt_real.candump.log";
  if (!exists(log)) GTEST_SKIP() << "no capture " << log;
  std::ifstream file(log);
  Ear ear;
  const auto driver = frame_driver(options(Kind::imu, "aceinna"));
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string time, interface, text;
    words >> time >> interface >> text;
    wire::CanFrame frame;
    frame.extended = true;
    frame.id = static_cast<std::uint32_t>(std::stoul(text.substr(0, 8), nullptr, 16));
    for (std::size_t i = 9; i + 1 < text.size(); i += 2) {
      frame.data[frame.size++] =
          static_cast<std::uint8_t>(std::stoul(text.substr(i, 2), nullptr, 16));
    }
    driver->receive(frame, at_s(std::stod(time.substr(1))), ear);
  }
  std::vector<nlohmann::json> accelerations;
  for (const auto& row : json_lines(corpora() / "can_imu/aceinna_mtlt_real.expected.jsonl")) {
    if (row.contains("acc_ms2")) accelerations.push_back(row["acc_ms2"]);
  }
  const auto samples = ear.all<measurement::ImuSample>();
  ASSERT_FALSE(samples.empty());
  for (const auto& s : samples) {
    EXPECT_TRUE(std::ranges::any_of(accelerations, [&](const nlohmann::json& a) {
      return std::abs(double(a[0]) - s.specific_force.x()) < 1e-9 &&
             std::abs(double(a[1]) - s.specific_force.y()) < 1e-9 &&
             std::abs(double(a[2]) - s.specific_force.z()) < 1e-9;
    }));
  }
}

TEST(Corpus, BothHeadsOfAnAuvGiveTheBottomTrackOfTheLowerOne) {
  // Heads that look up and down alternate in one file. The file's other reader has the velocity of
  // each; range and depth together are the same depth of water for both.
  const auto folder = corpora() / "dvl/pd0";
  if (!exists(folder / "raw/remus_20141219_a.adc")) GTEST_SKIP() << "no dive in " << folder;
  const Ear ear = ear_after(Kind::dvl, "pd0", read_all(folder / "raw/remus_20141219_a.adc"));
  const auto heard = ear.all<BottomVelocity>();
  const auto rows = json_lines(folder / "expected/remus_20141219_a.jsonl");
  std::size_t theirs = 0, ours = 0;
  for (const auto& row : rows) theirs += row.contains("vel_bt") && has_bottom_track(row) ? 1 : 0;
  for (const auto& m : heard) ours += m.velocity ? 1 : 0;
  EXPECT_GT(theirs, 1000U);
  EXPECT_GE(ours, theirs);
  EXPECT_TRUE(ear.refusals.empty());
}

}  // namespace corpus_test
}  // namespace drydock::device::test
