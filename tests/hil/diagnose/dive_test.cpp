// A receiver that loses its sky, on vehicles that know more or less of their depth.
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "drivers/host/finding_log.hpp"
#include "estimators/host/diagnostician.hpp"

namespace drydock::diagnose {
namespace dive_test {

using namespace measurement;
using diagnosis::Cause;

/// A level vehicle of 2 m/s with a receiver, and what else `with` names. Its ten satellites are
/// away from 100 s to 160 s.
struct Vessel {
  Vessel(std::initializer_list<Kind> with, double dive_mps, unsigned left = 0)
      : sinking_mps(dive_mps), satellites_left(left) {
    for (const Kind kind : {Kind::gnss, Kind::dvl, Kind::imu, Kind::depth})
      if (kind == Kind::gnss || std::ranges::count(with, kind) > 0) add(kind);
    diagnostician.emplace(rig, findings);
    for (long step = 0; step < 24000; ++step) tick(step);
  }
  void add(Kind kind) {
    auto& config = rig.devices.emplace_back();
    config.name = "device" + std::to_string(rig.devices.size());
    config.kind = kind;
    config.protocol = kind == Kind::gnss ? "ubx" : kind == Kind::dvl ? "pd0" : "nmea2000";
    config.link = "pty:" + config.name + "?baud=115200";
    config.rate_hz = kind == Kind::imu ? 100 : 5;
    if (kind == Kind::gnss) config.lever_arm_m = {0, 0, -0.6};
  }
  void tick(long step) {
    const double t = static_cast<double>(step) * 0.01;
    const bool away = t > 100 && t < 160;
    // Down for 20 s, up for the last 20 s of the sixty.
    const double down = t > 99 && t < 119 ? sinking_mps : t > 141 && t < 161 ? -sinking_mps : 0;
    depth_m += 0.01 * down;
    ImuSample inertial;
    inertial.specific_force = {noise(0.01), noise(0.01), noise(0.01) - 9.80665};
    inertial.angular_rate = {noise(1e-4), noise(1e-4), noise(1e-4)};
    give(Kind::imu, inertial, t);
    if (step % 20 != 0) return;
    BottomVelocity bottom;
    bottom.velocity = Eigen::Vector3d{2 + noise(0.01), noise(0.01), down + noise(0.01)};
    give(Kind::dvl, bottom, t);
    DepthSample below;
    below.depth_m = depth_m + noise(0.01);
    give(Kind::depth, below, t);
    GnssFix fix;
    if (!away || satellites_left > 3) {
      fix.velocity_ned = Eigen::Vector3d{2 + noise(0.05), noise(0.05), noise(0.05)};
      fix.position = Geodetic{(2 * t + noise(1)) / 6.371e6, noise(1) / 6.371e6};
    }
    give(Kind::gnss, fix, t);
    GnssSatellites sky;
    for (std::uint8_t i = 0; i < (away ? satellites_left : 10); ++i)
      sky.satellites.push_back({.number = static_cast<std::uint8_t>(i + 1),
                                .cno_dbhz = 40 + noise(0.5),
                                .elevation_rad = {},
                                .azimuth_rad = {}});
    give(Kind::gnss, sky, t);
  }
  template <class Sample>
  void give(Kind kind, Sample sample, double t) {
    for (std::size_t i = 0; i < rig.devices.size(); ++i) {
      if (rig.devices[i].kind != kind) continue;
      sample.origin.device = static_cast<std::uint16_t>(i);
      sample.origin.valid_at = sample.origin.received_at = Stamp{} + from_seconds(1000 + t);
      diagnostician->on_measurement(sample);
    }
  }
  double noise(double sigma) { return sigma * normal(random); }
  /// When the receiver's blocked sky was found, s; 0: it was not. No other finding is expected.
  double found_s() const {
    for (const auto& finding : findings.all())
      EXPECT_EQ(finding.cause, Cause::satellites_blocked) << facts_of(finding.cause).name;
    return findings.all().empty() ? 0
                                  : seconds(findings.all().front().found.time_since_epoch()) - 1000;
  }

  double sinking_mps, depth_m = 0;
  unsigned satellites_left;
  rig_config::Rig rig;
  host::FindingLog findings;
  std::optional<host::Diagnostician> diagnostician;
  std::mt19937_64 random{5};
  std::normal_distribution<double> normal;
};

TEST(DiagnosisOfADive, SaysNothingOfTheSatellitesThatItHides) {
  EXPECT_EQ(Vessel({Kind::depth}, 0.3).found_s(), 0);
  EXPECT_EQ(Vessel({Kind::dvl, Kind::imu}, 0.3).found_s(), 0);
  EXPECT_EQ(Vessel({Kind::dvl, Kind::imu}, 0.05).found_s(), 0) << "a slow one, of a metre";
  EXPECT_EQ(Vessel({Kind::imu}, 0.3).found_s(), 0);
  EXPECT_EQ(Vessel({}, 0.3).found_s(), 0);
}

TEST(DiagnosisOfABlockedAntenna, NamesItWhereTheVehicleIsKnownToStayAtTheSurface) {
  EXPECT_NEAR(Vessel({Kind::depth}, 0).found_s(), 100.5, 0.5);
  EXPECT_NEAR(Vessel({Kind::dvl, Kind::imu}, 0).found_s(), 111.5, 2);
}

TEST(DiagnosisOfABlockedAntenna, SaysNothingWhereItMayBeADive) {
  EXPECT_EQ(Vessel({}, 0).found_s(), 0);
}

TEST(DiagnosisOfABlockedAntenna, NamesItWhereSomeSatellitesAreLeft) {
  EXPECT_NEAR(Vessel({}, 0, 3).found_s(), 100.5, 0.5) << "water lets none through";
}

}  // namespace dive_test
}  // namespace drydock::diagnose
