// Healthy recordings of other people: docs/estimators/real-data.md has their sources. Their
// inertial units have gyro biases of up to 0.25 deg/s, which turn the level.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "drivers/diagnosis/symptom.hpp"
#include "estimators/consistency/consistency.hpp"
#include "tests/estimators/navigation/recordings/vehicles.hpp"

namespace drydock::consistency::recordings_test {
namespace {

namespace fs = std::filesystem;
namespace recorded = navigation::test;
using namespace measurement;

fs::path ins() {
  const char* named = std::getenv("DRYDOCK_CORPORA");
  return fs::path{named ? named : DRYDOCK_SOURCE_DIR "/../shared/corpora"} / "ins";
}

struct Signs final : diagnosis::SymptomSink {
  void see(const diagnosis::Symptom& symptom) override { all.push_back(symptom); }
  std::string text() const {
    std::string lines;
    for (const auto& one : all)
      lines += fmt::format("{:.1f} s device {}: {} of {}, {:.3g} {} (limit {:.3g})\n",
                           seconds(one.at.time_since_epoch()), one.device, to_string(one.sign),
                           one.quantity, one.value, one.unit, one.limit);
    return lines;
  }
  std::vector<diagnosis::Symptom> all;
};

Origin origin_of(double t, std::uint16_t device) {
  Origin origin;
  origin.valid_at = origin.received_at = Stamp{} + from_seconds(t);
  origin.device = device;
  return origin;
}

std::vector<Measurement> in_order(std::vector<Measurement> all) {
  std::ranges::stable_sort(
      all, {}, [](const Measurement& m) { return measurement::origin_of(m).received_at; });
  return all;
}

void add_imu(std::vector<Measurement>& all, const std::vector<recorded::ImuRow>& rows,
             const Eigen::Matrix3d& to_body) {
  for (const auto& row : rows) {
    ImuSample sample;
    sample.origin = origin_of(row.t, 0);
    sample.angular_rate = to_body * row.rate;
    sample.specific_force = to_body * row.force;
    all.emplace_back(sample);
  }
}

Signs signs_of(const std::vector<Sensor>& sensors, const std::vector<Measurement>& all) {
  Signs signs;
  Consistency checks(sensors, signs);
  Stamp next{};
  for (const Measurement& one : all) {
    checks.take(one);
    const Stamp now = measurement::origin_of(one).received_at;
    if (now < next) continue;
    checks.tell(now);
    next = now + std::chrono::milliseconds{250};
  }
  return signs;
}

/// Inertial unit, DVL and pressure sensor of an AUV in a pool.
class Pool : public testing::TestWithParam<const char*> {};

TEST_P(Pool, AccusesNothingButTheUncalibratedInertialUnit) {
  const fs::path folder = ins() / "sonia_pool" / GetParam();
  if (!fs::exists(folder)) GTEST_SKIP() << "corpora absent: " << folder;
  const auto read = recorded::read_pool(folder);
  ASSERT_TRUE(read.has_value()) << read.error().line;
  const auto setup = recorded::sonia();
  std::vector<Measurement> all;
  add_imu(all, read->imu, setup.imu_to_body);
  for (const auto& ping : read->dvl) {
    BottomVelocity bottom;
    bottom.origin = origin_of(ping.t, 1);
    bottom.velocity = setup.dvl_to_body * ping.value;
    all.emplace_back(bottom);
  }
  for (const auto& pressed : read->pressure) {
    DepthSample below;
    below.origin = origin_of(pressed.t, 2);
    below.depth_m = pressed.pascal / setup.density / 9.80665;
    all.emplace_back(below);
  }
  const auto rate = [](const auto& rows) {
    return static_cast<double>(rows.size()) / (rows.back().t - rows.front().t);
  };
  const Signs signs = signs_of(
      {{.kind = Kind::imu, .rate_hz = rate(read->imu)},
       {.kind = Kind::dvl, .rate_hz = rate(read->dvl), .lever_arm_m = setup.dvl_lever},
       {.kind = Kind::depth, .rate_hz = rate(read->pressure), .lever_arm_m = setup.pressure_lever}},
      in_order(std::move(all)));
  for (const auto& one : signs.all) EXPECT_EQ(one.device, 0) << signs.text();
}
INSTANTIATE_TEST_SUITE_P(Recordings, Pool,
                         testing::Values("TEST_PISCINE_20160305_CIRCLE",
                                         "TEST_PISCINE_20160305_SQUARE"));

TEST(Recordings, ACarAccusesNothingButItsUncalibratedInertialUnit) {
  const fs::path folder = ins() / "rtklibexplorer_GNSS_IMU/drive_0708";
  if (!fs::exists(folder)) GTEST_SKIP() << "corpora absent: " << folder;
  const auto read = recorded::read_drive(folder);
  ASSERT_TRUE(read.has_value()) << read.error().line;
  std::vector<Measurement> all;
  add_imu(all, read->imu, recorded::car().imu_to_body);
  for (const auto& row : read->fixes) {
    GnssFix fix;
    fix.origin = origin_of(row.t, 1);
    fix.velocity_ned = row.velocity_ned;
    fix.position = Geodetic{row.position.latitude_rad, row.position.longitude_rad};
    all.emplace_back(fix);
  }
  const double fixes_s = read->fixes.back().t - read->fixes.front().t;
  const Signs signs =
      signs_of({{.kind = Kind::imu, .rate_hz = 100},
                {.kind = Kind::gnss, .rate_hz = static_cast<double>(read->fixes.size()) / fixes_s}},
               in_order(std::move(all)));
  for (const auto& one : signs.all) EXPECT_EQ(one.device, 0) << signs.text();
}

}  // namespace
}  // namespace drydock::consistency::recordings_test
