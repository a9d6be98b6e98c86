// The short form of ./rig soak: hours instead of days. A watch that detects nothing would pass
// everything, so the tests also give it a stuck device and a growing process.
#include "hil/endurance/soak.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "hil/bench/run.hpp"
#include "hil/endurance/soak_watch.hpp"
#include "rig_config/load.hpp"

namespace soak_test {
namespace {

using namespace drydock;

rig_config::Rig rig() {
  return rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/soak.toml").value();
}

TEST(Soak, HoursOfRandomFaultsLeaveNothingStuckLostOrGrown) {
  const auto file = std::filesystem::temp_directory_path() / "drydock-soak-test.json";
  endurance::SoakOptions options;
  options.duration_s = 4 * 3600;
  options.fault_interval_s = 300;
  options.json = file;
  testing::internal::CaptureStdout();
  const int code = endurance::soak(rig(), options, stdout);
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_EQ(code, 0) << said;
  EXPECT_THAT(said, testing::HasSubstr("PASS 14400 looks"));

  const auto json = nlohmann::json::parse(std::ifstream(file));
  EXPECT_EQ(json["troubles"].size(), 0u);
  // 18 devices; each has a fault after 300 s on average, which lasts half a minute: Poisson.
  EXPECT_NEAR(json["faults"].get<double>(), 18 * 4 * 3600 / 330.0, 4 * 28);
  EXPECT_GE(json["faults_by_word"].size(), 30u) << "nearly every word of the vocabulary";
  for (const auto& device : json["devices"]) {
    EXPECT_EQ(device["bytes_in"].get<std::uint64_t>(),
              device["bytes_good"].get<std::uint64_t>() +
                  device["bytes_skipped"].get<std::uint64_t>() +
                  device["bytes_held"].get<std::uint64_t>())
        << device["name"];
    EXPECT_GT(device["messages"].get<std::uint64_t>(), 4 * 3600 * 0.7) << device["name"];
  }
  std::filesystem::remove(file);
}

TEST(Soak, TheWatchSeesADeviceThatNoFaultExplains) {
  auto bench = rig();
  bench.faults = rig_config::load_faults_text(
                     "[[fault]]\ndevice = \"log\"\nfault = \"hang\"\nstart_s = 200\n", "test")
                     .value();
  constexpr double never_s = 1e9;
  endurance::SoakWatch watch(bench, 1, never_s);
  bench::RunOptions options;
  options.duration_s = 300;
  options.quiet = true;
  options.followers = {&watch};
  bench::run_lockstep(bench, options);
  EXPECT_EQ(watch.faults_set(), 0u);
  EXPECT_THAT(watch.troubles(), testing::Contains(testing::HasSubstr("log is ")));
}

}  // namespace
}  // namespace soak_test
