#include "tests/hil/gpsd/gpsd.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <set>

#include "drivers/wire/ubx/ubx.hpp"
#include "hil/sensor/sky.hpp"
#include "tests/drivers/wire/byte_streams.hpp"
#include "tests/hil/emulate/bench.hpp"
#include "tests/test_name.hpp"

/// gpsd reads the emulated receiver. Its reports must equal the receiver's truth.
namespace drydock::peer {
namespace {

using emulate::at_s;
using emulate::degree;
using measurement::Stamp;

constexpr int seconds = 60;
// gpsd needs some epochs to learn which sentence ends an epoch, and holds the last epoch back.
constexpr int to_learn = 8;

/// Moves north-east on the surface and accelerates, so that values of different epochs differ.
class Speeding final : public motion::Trajectory {
 public:
  motion::Truth at(Stamp time) const override {
    const double t = measurement::seconds(time - start());
    motion::Truth truth = emulate::at_the_surface();
    truth.at = time;
    const double speed = 1 + 0.05 * t, gone = t + 0.025 * t * t, course = (20 + 0.5 * t) * degree;
    truth.latitude_rad += gone * 1.2e-7;
    truth.longitude_rad += gone * 1.9e-7;
    truth.velocity_ned = {speed * std::cos(course), speed * std::sin(course), 0.001 * t};
    truth.velocity_body = truth.body_to_ned.inverse() * truth.velocity_ned;
    truth.height_m = -0.1 + 0.01 * t;
    return truth;
  }
  Stamp start() const override { return emulate::start; }
  Stamp end() const override { return at_s(seconds + to_learn); }
};

/// Half a digit of the wire format, plus gpsd's own rounding.
struct Resolution {
  double position_deg, height_m, speed_mps, course_deg, direction_deg, cno_dbhz;
};
constexpr double knot_mps = 1852.0 / 3600;
const Resolution ubx_resolution{0.51e-7, 0.51e-3, 1.01e-3, 0.51e-4, 0.51, 0.51};
const Resolution nmea_resolution{0.51e-5 / 60, 0.51e-2, 1e-3 * knot_mps, 0.51e-2, 0.51, 0.51};

Stamp time_of(const nlohmann::json& report) {
  std::tm utc{};
  const std::string text = report["time"];
  EXPECT_NE(::strptime(text.c_str(), "%Y-%m-%dT%H:%M:%S", &utc), nullptr) << text;
  return Stamp{std::chrono::seconds{::timegm(&utc)}};
}

void expect_truth(const nlohmann::json& tpv, const motion::Truth& truth, const Resolution& r) {
  const auto near = [&](const char* key, double value, double tolerance) {
    if (tpv.contains(key)) {
      EXPECT_NEAR(tpv[key].get<double>(), value, tolerance) << tpv;
    }
  };
  const auto& v = truth.velocity_ned;
  near("lat", truth.latitude_rad / degree, r.position_deg);
  near("lon", truth.longitude_rad / degree, r.position_deg);
  near("altHAE", truth.height_m, r.height_m);
  near("speed", v.head<2>().norm(), r.speed_mps);
  near("track", std::atan2(v.y(), v.x()) / degree, r.course_deg);
}

/// gpsd's satellites must have the number, elevation, azimuth and C/N0 of the truth.
void expect_sky(const nlohmann::json& sky, const motion::Truth& truth, const Resolution& r) {
  const auto expected = sensor::ideal_sky(truth, false).satellites;
  ASSERT_EQ(sky["satellites"].size(), expected.size()) << sky;
  for (const auto& satellite : expected) {
    const auto& all = sky["satellites"];
    const auto found = std::ranges::find_if(
        all, [&](const auto& s) { return s["gnssid"] == 0 && s["svid"] == satellite.number; });
    ASSERT_NE(found, all.end()) << int{satellite.number};
    EXPECT_NEAR((*found)["el"].get<double>(), *satellite.elevation_rad / degree, r.direction_deg);
    EXPECT_NEAR((*found)["az"].get<double>(), *satellite.azimuth_rad / degree, r.direction_deg);
    EXPECT_NEAR((*found)["ss"].get<double>(), *satellite.cno_dbhz, r.cno_dbhz);
    EXPECT_EQ((*found)["used"].get<bool>(), satellite.used);
  }
}

struct Case {
  const char* protocol;
  Resolution resolution;
};

class Gpsd : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    if (!gpsd_is_installed()) GTEST_SKIP() << "gpsd is not installed (package gpsd)";
  }
};

TEST_P(Gpsd, ReportsTheTruthOfAnEmulatedReceiverForAMinute) {
  const auto [protocol, resolution] = GetParam();
  const Speeding trajectory;
  const auto sent = emulate::record(emulate::device(rig_config::DeviceKind::gnss, protocol),
                                    trajectory, seconds + to_learn);
  const auto told = [&](const Reports& reports) {
    return !reports.empty() && reports.back()["class"] == "TPV" &&
           reports.back().contains("time") &&
           time_of(reports.back()) >= at_s(seconds + to_learn - 2);
  };
  std::set<Stamp> told_epochs;
  std::size_t skies = 0;
  std::optional<Stamp> now;
  for (const auto& report : reports_of_gpsd(sent.all_bytes(), told)) {
    if (report["class"] == "TPV" && report.contains("lat")) {
      now = time_of(report);
      expect_truth(report, trajectory.at(*now), resolution);
      told_epochs.insert(*now);
    }
    if (report["class"] == "SKY" && report.contains("satellites") && now) {
      ++skies;
      expect_sky(report, trajectory.at(*now), resolution);
    }
  }
  EXPECT_GE(told_epochs.size(), static_cast<std::size_t>(seconds));
  EXPECT_EQ(measurement::seconds(*told_epochs.rbegin() - *told_epochs.begin()),
            static_cast<double>(told_epochs.size() - 1))
      << "no second is missing";
  EXPECT_GE(skies, static_cast<std::size_t>(seconds));
}

INSTANTIATE_TEST_SUITE_P(Protocols, Gpsd,
                         testing::Values(Case{"ubx", ubx_resolution},
                                         Case{"nmea0183", nmea_resolution}),
                         [](const auto& one) {
                           return drydock::test::test_name(one.param.protocol);
                         });

/// gpsd leaves out invalid values, and a carrier phase with unknown accuracy.
void expect_same(const nlohmann::json& row, const char* key, const std::optional<double>& ours) {
  if (!row.contains(key)) return;
  ASSERT_TRUE(ours.has_value()) << row;
  EXPECT_NEAR(row[key].get<double>(), *ours, 1e-6);
}

TEST(GpsdOfACapture, ReadsTheRawMeasurementsThatWeRead) {
  namespace wt = wire::testing;
  const auto log = wt::corpora() / "gps/pyubx2/pygpsdata-RXMRAWX.log";
  if (!std::filesystem::exists(log)) GTEST_SKIP() << "no capture " << log;
  if (!gpsd_is_installed()) GTEST_SKIP() << "gpsd is not installed (package gpsd)";
  const auto stream = wt::read_file(log);
  const auto ours = wt::read_stream<wire::Ubx>(stream).all<wire::RxmRawx>();
  const auto theirs = of_class(
      reports_of_gpsd(
          stream,
          [&](const Reports& reports) { return of_class(reports, "RAW").size() == ours.size(); }),
      "RAW");
  ASSERT_EQ(theirs.size(), ours.size());
  int carriers = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const auto& rows = theirs[i]["rawdata"];
    ASSERT_EQ(rows.size(), ours[i].measurements.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const auto& m = ours[i].measurements[k];
      EXPECT_EQ(rows[k]["gnssid"], static_cast<int>(m.gnss));
      EXPECT_EQ(rows[k]["svid"], m.number);
      EXPECT_EQ(rows[k]["snr"], m.cno_dbhz.value_or(0));
      EXPECT_EQ(rows[k]["locktime"], m.lock_time.count());
      expect_same(rows[k], "pseudorange", m.pseudorange_m);
      expect_same(rows[k], "carrierphase", m.carrier_phase_cycles);
      expect_same(rows[k], "doppler", m.doppler_hz);
      carriers += rows[k].contains("carrierphase");
    }
  }
  EXPECT_GT(carriers, 150) << "of 314";
}

}  // namespace
}  // namespace drydock::peer
