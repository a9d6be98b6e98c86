// Broadcast orbits and clocks compared with the final orbits of the International GNSS Service.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "hil/sky/broadcast_orbits.hpp"
#include "hil/sky/ephemeris_file.hpp"
#include "hil/sky/orbit.hpp"
#include "tests/hil/sky/files.hpp"

namespace drydock::sky {
namespace igs_test {

using namespace std::chrono;

struct Precise {
  GpsTime at;
  int prn;
  Eigen::Vector3d ecef_m;
  double clock_s;  ///< without the periodic part of relativity, as in IGS files
};

/// SP3-c: lines "*  year month day hour minute second" and "PG01 x y z [km] clock [us]".
std::vector<Precise> read_sp3(const std::string& text) {
  std::vector<Precise> states;
  std::istringstream lines(text);
  GpsTime at;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("* ")) {
      int y = 0;
      unsigned mo = 0, d = 0, h = 0, mi = 0;
      std::istringstream(line.substr(1)) >> y >> mo >> d >> h >> mi;
      at = gps_time(sys_days{year{y} / month{mo} / day{d}}, hours{h} + minutes{mi});
    } else if (line.starts_with("PG")) {
      Precise p{at, std::stoi(line.substr(2, 2)), {}, 0};
      double clock_us = 0;
      std::istringstream(line.substr(4)) >> p.ecef_m.x() >> p.ecef_m.y() >> p.ecef_m.z() >>
          clock_us;
      p.ecef_m *= 1000;
      p.clock_s = clock_us * 1e-6;
      states.push_back(p);
    }
  }
  return states;
}

class Igs : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(test::gnss_corpus() / "igs15904.sp3"))
      GTEST_SKIP() << "the corpora are not here: " << test::gnss_corpus();
    precise_ = read_sp3(test::text_of(test::gnss_corpus() / "igs15904.sp3"));
    const auto path = (test::gnss_corpus() / "brdc1820.10n").string();
    orbits_ = BroadcastOrbits(read_navigation_file(path).value().records);
  }
  std::vector<Precise> precise_;
  BroadcastOrbits orbits_{{}};
};

TEST_F(Igs, OverADayTheBroadcastIsWithinTwoMetresOfTheFinalOrbits) {
  double squares = 0, worst = 0;
  int epochs = 0;
  for (const Precise& p : precise_) {
    const Ephemeris* record = orbits_.nearest(p.prn, p.at);
    if (record == nullptr) continue;
    const double error = (satellite_at(*record, p.at).ecef_m - p.ecef_m).norm();
    squares += error * error;
    worst = std::max(worst, error);
    ++epochs;
  }
  const double rms = std::sqrt(squares / epochs);
  RecordProperty("epochs", epochs);
  RecordProperty("rms_3d_m", std::to_string(rms));
  RecordProperty("worst_m", std::to_string(worst));
  EXPECT_EQ(epochs, 2880);  // 96 epochs of 30 satellites: all but PRN 01 and 25
  EXPECT_LT(rms, 2.0);
  EXPECT_LT(worst, 10);
}

TEST_F(Igs, ClocksAgreeToSomeNanosecondsOnceTheTimeScalesDo) {
  std::map<GpsTime, std::vector<double>> by_epoch;
  for (const Precise& p : precise_) {
    const Ephemeris* record = orbits_.nearest(p.prn, p.at);
    if (record == nullptr || std::abs(p.clock_s) > 0.5) continue;
    const SatelliteState state = satellite_at(*record, p.at);
    by_epoch[p.at].push_back(state.clock_s - state.relativity_s - p.clock_s);
  }
  double squares = 0;
  int count = 0;
  for (auto& [at, differences] : by_epoch) {
    // The two time scales differ by an offset that all satellites share.
    std::ranges::nth_element(differences, differences.begin() + differences.size() / 2);
    const double common = differences[differences.size() / 2];
    for (const double d : differences) squares += (d - common) * (d - common), ++count;
  }
  const double rms_ns = std::sqrt(squares / count) * 1e9;
  RecordProperty("rms_ns", std::to_string(rms_ns));
  EXPECT_GT(count, 2000);
  EXPECT_LT(rms_ns, 10);
}

TEST_F(Igs, TheBogusRecordOfSatelliteOneIsRefused) {
  // Its content is that of satellite 23 at the same hour: healthy, sound, and 40 000 km wrong.
  ASSERT_EQ(orbits_.refused().size(), 1);
  const Ephemeris& bogus = orbits_.refused()[0].record;
  EXPECT_EQ(bogus.prn, 1);
  EXPECT_EQ(bogus.line, 937);
  EXPECT_TRUE(bogus.healthy());
  EXPECT_FALSE(absurd(bogus));
  EXPECT_EQ(orbits_.nearest(23, bogus.toe)->m0_rad, bogus.m0_rad);
  EXPECT_THAT(orbits_.refused()[0].why, testing::HasSubstr("(8 against, 0 for)"));
  for (const Precise& p : precise_)
    EXPECT_EQ(p.prn == 1 ? orbits_.nearest(1, p.at) : nullptr, nullptr);
}

TEST_F(Igs, TheOtherDaysOfTheCorpusAreReadWhole) {
  for (const auto& [name, leap] : {std::pair{"brdc3050.12n", 16}, std::pair{"07590920.05n", 13}}) {
    const auto file = read_navigation_file((test::gnss_corpus() / name).string());
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_EQ(file->leap_seconds, leap);
    EXPECT_GT(file->records.size(), 100) << name;
    for (const Ephemeris& r : file->records)
      EXPECT_LT(std::chrono::abs(r.toe - r.toc), hours{3}) << name << ':' << r.line;
    for (const auto& refused : BroadcastOrbits(file->records).refused())
      ADD_FAILURE() << name << ':' << refused.record.line << ": " << refused.why;
  }
}

}  // namespace igs_test
}  // namespace drydock::sky
