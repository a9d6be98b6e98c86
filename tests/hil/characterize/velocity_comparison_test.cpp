#include "hil/characterize/compare/velocity_comparison.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "hil/characterize/device_figures.hpp"
#include "hil/characterize/report/characterize.hpp"

namespace {

using namespace drydock;
using characterize::Samples;

/// The demonstration's DVL, receiver and IMU in their places there, on a mission with changing
/// speed.
class DvlAgainstGnss : public testing::Test {
 protected:
  DvlAgainstGnss() {
    auto name = (std::filesystem::temp_directory_path() / "drydock-velocities-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    std::ofstream(folder_ / "mission.toml")
        << "[mission]\nlatitude_deg = 36\nlongitude_deg = 129\ndepth_m = 0\nheading_deg = 0\n"
           "speed_mps = 1\n[ocean]\nbed = { kind = \"plane\", depth_m = 60 }\n"
           "[[leg]]\nkind = \"straight\"\nduration_s = 20\nspeed_mps = 3\n"
           "[[leg]]\nkind = \"s_path\"\nduration_s = 30\namplitude_deg = 45\nperiod_s = 30\n"
           "[[leg]]\nkind = \"turn\"\nduration_s = 10\nturn_deg = 90\nroll_deg = 5\n"
           "[[leg]]\nkind = \"straight\"\nduration_s = 20\nspeed_mps = 1\n";
  }
  ~DvlAgainstGnss() override { std::filesystem::remove_all(folder_); }

  std::vector<Samples> run(const std::string& dvl_errors, const std::string& gnss_more = "",
                           const std::string& dvl_protocol = "pd0") {
    std::ofstream(folder_ / "rig.toml")
        << "[rig]\nname = \"bench\"\nseed = " << seed_
        << "\nmission = \"mission.toml\"\n"
           "start = 2026-11-21T08:00:00Z\n"
           "[[device]]\nname = \"dvl\"\nkind = \"dvl\"\nprotocol = \"" +
               dvl_protocol +
               "\"\nlink = \"pty:dvl?baud=115200\"\nrate_hz = 5\nlever_arm_m = [0.8, 0, 0.35]\n"
               "mounting_deg = [0, 0, 45]\n"
               "emulate = { fixed_bias = true, velocity_noise_mps = 0.01" +
               dvl_errors +
               " }\n"
               "[[device]]\nname = \"gnss\"\nkind = \"gnss\"\nprotocol = \"ubx\"\n"
               "link = \"pty:gnss?baud=38400\"\nrate_hz = 5\nlever_arm_m = [0.2, 0, -0.6]\n"
               "emulate = { velocity_noise_mps = 0.05" +
               gnss_more +
               " }\n"
               "[[device]]\nname = \"imu\"\nkind = \"imu\"\nprotocol = \"cia404-imu\"\n"
               "link = \"memory-can:bus?bitrate=250000\"\nrate_hz = 100\naddress = 1\n"
               "mounting_deg = [180, 0, 0]\n"
               // The [[expect]] block of the rig must not matter here.
               "[[estimator]]\nname = \"leveling\"\nkind = \"leveling\"\nimu = \"imu\"\nmodel = "
               "\"stationary\"\nlatitude_deg = 36\n[[expect]]\nestimator = "
               "\"leveling\"\nroll_rms_deg_max = 2\n";
    characterize::CharacterizeOptions options;
    options.source = (folder_ / "rig.toml").string();
    options.duration_s = duration_s_;
    testing::internal::CaptureStdout();
    auto gathered = characterize::gather(options);
    testing::internal::GetCapturedStdout();
    return std::move(gathered.devices);
  }

  std::filesystem::path folder_;
  int seed_ = 5;
  double duration_s_ = 1200;
};

constexpr const char* known_errors =
    ", velocity_scale_factor_ppm = 5000, velocity_bias_mps = [0.02, -0.01, 0]"
    ", velocity_misalignment_mrad = [-10, 10, 0]";

TEST_F(DvlAgainstGnss, ScaleBiasAngleAndLatencyComeBackWithinTheirBounds) {
  const auto devices = run(known_errors, ", latency_ms = 40");
  const auto found =
      characterize::compare(characterize::AtOnePlace(devices[0], devices[1], &devices[2]));
  ASSERT_TRUE(found && found->scale && found->angle_rad && found->delay_s);
  EXPECT_TRUE(found->scale->holds(1.005)) << found->scale->value;
  EXPECT_TRUE(found->bias[0].holds(0.02)) << found->bias[0].value;
  EXPECT_TRUE(found->bias[1].holds(-0.01)) << found->bias[1].value;
  EXPECT_TRUE(found->angle_rad->holds(0.01)) << found->angle_rad->value;
  EXPECT_TRUE(found->delay_s->holds(-0.04)) << found->delay_s->value;
  EXPECT_LT(found->scale->high - found->scale->low, 0.01);
  EXPECT_LT(found->angle_rad->high - found->angle_rad->low, 0.01);
  EXPECT_LT(found->delay_s->high - found->delay_s->low, 0.1);
}

TEST_F(DvlAgainstGnss, OfASensorWithoutErrorsNothingButTheTruthIsFound) {
  const auto devices = run("");
  const auto found =
      characterize::compare(characterize::AtOnePlace(devices[0], devices[1], &devices[2]));
  ASSERT_TRUE(found && found->scale);
  EXPECT_TRUE(found->scale->holds(1)) << found->scale->value;
  EXPECT_TRUE(found->angle_rad->holds(0)) << found->angle_rad->value;
  EXPECT_TRUE(found->bias[0].holds(0) && found->bias[1].holds(0));
}

TEST_F(DvlAgainstGnss, WithoutAnImuStraightLegsAloneStillGiveTheTruth) {
  const auto devices = run(known_errors);
  const auto found =
      characterize::compare(characterize::AtOnePlace(devices[0], devices[1], nullptr));
  const auto all =
      characterize::compare(characterize::AtOnePlace(devices[0], devices[1], &devices[2]));
  ASSERT_TRUE(found && found->scale && all);
  EXPECT_TRUE(found->scale->holds(1.005)) << found->scale->value;
  EXPECT_LT(found->blocks, all->blocks * 3 / 4);
}

TEST_F(DvlAgainstGnss, ADvlWithoutACompassIsComparedAlongTheCourse) {
  const auto devices = run(", velocity_scale_factor_ppm = 5000", "", "nortek");
  const characterize::AtOnePlace velocities(devices[0], devices[1], &devices[2]);
  EXPECT_FALSE(velocities.has_attitude());
  const auto found = characterize::compare(velocities);
  ASSERT_TRUE(found && found->scale);
  EXPECT_TRUE(found->scale->holds(1.005)) << found->scale->value << ' ' << found->scale->low;
}

/// 95 %: fewer than 34 of 40 happen about once in a thousand.
TEST_F(DvlAgainstGnss, BoundsHoldAsOftenAsTheySay) {
  duration_s_ = 400;
  int held = 0;
  for (seed_ = 1; seed_ <= 8; ++seed_) {
    const auto devices = run(known_errors);
    const auto found =
        characterize::compare(characterize::AtOnePlace(devices[0], devices[1], &devices[2]));
    ASSERT_TRUE(found && found->scale);
    held += found->scale->holds(1.005) + found->angle_rad->holds(0.01) + found->delay_s->holds(0) +
            found->bias[0].holds(0.02) + found->bias[1].holds(-0.01);
  }
  EXPECT_GE(held, 34);
}

}  // namespace
