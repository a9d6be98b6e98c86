// Sensors without a fault on hulls, speeds and manoeuvres that no shipped mission has: what is
// found there is a false alarm.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "hil/bench/run.hpp"
#include "rig_config/load.hpp"

namespace healthy_missions_test {
namespace {

using namespace drydock;
namespace fs = std::filesystem;

const fs::path shipped = DRYDOCK_SOURCE_DIR "/rig_config";

struct Sailed {
  std::string vehicle;
  double depth_m, speed_mps;
  std::string current;  ///< north, east, down in m/s
  std::string legs;
};

std::string straight(double seconds, double speed_mps) {
  return fmt::format("[[leg]]\nkind = \"straight\"\nduration_s = {:.1f}\nspeed_mps = {:.2f}\n",
                     seconds, speed_mps);
}

std::string turn(double seconds, double degrees) {
  return fmt::format("[[leg]]\nkind = \"turn\"\nduration_s = {:.1f}\nturn_deg = {:.1f}\n", seconds,
                     degrees);
}

rig_config::Rig demo_on(const Sailed& sailed, std::uint64_t seed) {
  const auto file = fs::temp_directory_path() / fmt::format("drydock-healthy-{}.toml", ::getpid());
  std::ofstream(file) << fmt::format(
      "[mission]\nlatitude_deg = 36.0\nlongitude_deg = 129.0\ndepth_m = {:.1f}\n"
      "heading_deg = 10.0\nspeed_mps = {:.2f}\nvehicle = \"{}\"\n[ocean]\n"
      "bed = {{ kind = \"plane\", depth_m = 45.0 }}\n"
      "current = [{{ depth_m = 0.0, velocity_ned_mps = [{}] }}]\n{}",
      sailed.depth_m, sailed.speed_mps, (shipped / "vehicles" / sailed.vehicle).string(),
      sailed.current, sailed.legs);
  auto rig = rig_config::load_rig((shipped / "rigs/demo.toml").string()).value();
  rig.mission = rig_config::load_mission(file.string()).value();
  rig.seed = seed;
  fs::remove(file);
  return rig;
}

void expect_nothing_found(const rig_config::Rig& rig, double seconds, std::size_t devices) {
  SCOPED_TRACE(fmt::format("seed {}", rig.seed));
  bench::RunOptions options;
  options.duration_s = seconds;
  options.quiet = true;
  const auto summary = bench::run_lockstep(rig, options);
  EXPECT_NEAR(summary.duration_s, seconds, 1);
  EXPECT_EQ(summary.devices.size(), devices);
  EXPECT_TRUE(summary.all_streaming());
  for (const auto& finding : summary.findings)
    ADD_FAILURE() << finding.device << " " << finding.cause << " at " << finding.since_s << " s";
}

TEST(HealthyMissions, HaveNoFindingOnAHullThatTurnsAndChangesItsSpeed) {
  const std::string still = "0.0, 0.0, 0.0", moving = "0.4, -0.3, 0.0";
  const std::string hull = "nps-auv-ii.toml", other = "nps-auv-ii-asymmetric.toml";
  const Sailed all[] = {
      {hull, 4, 1.8, still, straight(60, 1.8) + turn(45, 90)},
      {hull, 0, 1.8, still, straight(60, 1.8) + turn(45, 90)},
      {hull, 4, 1.8, moving, straight(60, 1.2) + straight(60, 1.8)},
      {hull, 4, 1.2, still, straight(60, 1.2) + turn(70, 200)},
      {hull, 4, 0.8, still, straight(30, 0.8) + turn(20, 60) + turn(20, -60)},
      {other, 4, 1.8, moving, straight(60, 1.8) + turn(45, 90)},
  };
  std::uint64_t seed = 0;
  for (const Sailed& sailed : all) {
    expect_nothing_found(demo_on(sailed, ++seed), 900, 6);
  }
}

TEST(HealthyMissions, HaveNoFindingWhereElevenDvlsDiveAtThreeMetresASecond) {
  auto rig = rig_config::load_rig((shipped / "rigs/soak.toml").string()).value();
  for (const std::uint64_t seed : {2, 4, 6}) {
    rig.seed = seed;
    expect_nothing_found(rig, 300, 20);
  }
}

}  // namespace
}  // namespace healthy_missions_test
