// The short form of ./rig soak: hours instead of days. A watch that detects nothing would pass
// everything, so the tests also give it a stuck device and a growing process.
#include "hil/endurance/soak.hpp"

#include <gmock/gmock.h>
#include <sys/prctl.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "hil/bench/run.hpp"
#include "hil/endurance/emulated_rig.hpp"
#include "hil/endurance/soak_watch.hpp"
#include "rig_config/load.hpp"
#include "tests/no_quarantine.hpp"

namespace soak_test {
namespace {

using namespace drydock;

rig_config::Rig rig() {
  return rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/soak.toml").value();
}

/// From 200 s on; `more` of its fault.
rig_config::Rig rig_whose_log_hangs(const std::string& more) {
  auto all = rig();
  const std::string fault = "[[fault]]\ndevice = \"log\"\nfault = \"hang\"\nstart_s = 200\n";
  all.faults = rig_config::load_faults_text(fault + more, "test").value();
  return all;
}

void run(const rig_config::Rig& rig, double seconds, std::vector<bench::Follower*> followers) {
  bench::RunOptions options;
  options.duration_s = seconds;
  options.quiet = true;
  options.followers = std::move(followers);
  bench::run_lockstep(rig, options);
}

TEST(Soak, HoursOfRandomFaultsLeaveNothingStuckLostOrGrown) {
  const auto file = std::filesystem::temp_directory_path() / "drydock-soak-test.json";
  endurance::SoakOptions options;
  options.duration_s = 4 * 3600;
  options.fault_interval_s = 300;
  options.json = file;
#ifdef __SANITIZE_ADDRESS__
  options.most_growth_mb = 5;  // the sanitizer puts zones around each block
#endif
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

/// The flight of 700 m/s at 45 degrees lasts some 87 s. No receiver lives behind the impact.
TEST(Soak, EndsWithTheImpactOfAFlight) {
  const auto rocket =
      rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/sounding-rocket.toml").value();
  endurance::SoakOptions options;
  options.duration_s = 3600;
  options.faults = false;
  testing::internal::CaptureStdout();
  const int code = endurance::soak(rocket, options, stdout);
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_EQ(code, 0) << said;
  EXPECT_THAT(said, testing::HasSubstr("the flight of its mission ends after 8"));
  EXPECT_THAT(said, testing::HasSubstr("0 are false alarms"));
}

TEST(Soak, MeasuresMemoryWithoutHugePages) {
  prctl(PR_SET_THP_DISABLE, 0, 0, 0, 0);
  endurance::SoakOptions options;
  options.duration_s = 1;
  testing::internal::CaptureStdout();
  endurance::soak(rig(), options, stdout);
  testing::internal::GetCapturedStdout();
  EXPECT_EQ(prctl(PR_GET_THP_DISABLE, 0, 0, 0, 0), 1);
}

TEST(Soak, ASeedIsThatOfTheSensorsToo) {
  const auto file = std::filesystem::temp_directory_path() / "drydock-soak-seed-test.json";
  endurance::SoakOptions options;
  options.duration_s = 30;
  options.faults = false;
  options.seed = 9;
  options.json = file;
  testing::internal::CaptureStdout();
  endurance::soak(rig(), options, stdout);
  testing::internal::GetCapturedStdout();
  EXPECT_EQ(nlohmann::json::parse(std::ifstream(file))["seed"], 9);
  std::filesystem::remove(file);
}

TEST(Soak, TheWatchSeesADeviceThatNoFaultExplains) {
  const auto bench = rig_whose_log_hangs("");
  constexpr double never_s = 1e9;
  endurance::SoakWatch watch(bench, 1, never_s);
  run(bench, 300, {&watch});
  EXPECT_EQ(watch.faults_set(), 0u);
  EXPECT_THAT(watch.troubles(), testing::Contains(testing::HasSubstr("log is ")));
}

TEST(Soak, ARigOfRealSensorsRunsOnEmulatedLinesAtTheSameRates) {
  const auto real =
      rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/bench-serial.toml").value();
  const auto twin = endurance::all_emulated(real);
  EXPECT_EQ(twin.devices[0].link, "memory:line1?baud=115200");
  EXPECT_EQ(twin.devices[2].link, real.devices[2].link) << "it was emulated already";
  EXPECT_EQ(twin.devices[4].link, "memory-can:line4?bitrate=250000");
  bench::RunOptions options;
  options.duration_s = 20;
  options.quiet = true;
  EXPECT_TRUE(bench::run_lockstep(twin, options).all_streaming());
}

/// A fault of the rig from 200 s to 210 s: what is found then is none, what is found after 330 s
/// is.
TEST(Soak, AFindingIsAFalseAlarmOnlyWhileNoDeviceHasAFaultAndSinceSomeTime) {
  const auto bench = rig_whose_log_hangs("for_s = 10\n");
  struct Alarm final : bench::Follower {
    void tick(Stamp now) override {
      if (to == nullptr) return;
      diagnosis::Finding finding;
      finding.since = finding.found = now;
      to->on_finding(finding);
    }
    endurance::SoakWatch* to = nullptr;
  };
  endurance::SoakWatch watch(bench, 1, std::nullopt);
  Alarm alarm;
  run(bench, 400, {&alarm, &watch});
  const auto before = watch.false_alarms();
  EXPECT_NEAR(watch.quiet_s(), 400 - 10 - 120, 2);

  endurance::SoakWatch alarmed(bench, 1, std::nullopt);
  alarm.to = &alarmed;
  run(bench, 400, {&alarm, &alarmed});
  EXPECT_NEAR(static_cast<double>(alarmed.false_alarms() - before), 400 - 10 - 120, 2);
  EXPECT_THAT(alarmed.troubles(), testing::Contains(testing::HasSubstr("false alarm: ")));
}

/// Two findings begin in a fault from 200 to 210 s. One is over at 250 s, the other gets a better
/// word at 340 s and is counted once.
TEST(Soak, InARestWhatIsStillFoundTwoMinutesBehindTheLastFaultIsAFalseAlarm) {
  const auto bench = rig_whose_log_hangs("for_s = 10\n");
  struct Findings final : bench::Follower {
    void on_start(const bench::BenchView& bench) override { start = bench.start; }
    void tick(Stamp now) override {
      diagnosis::Finding finding;
      finding.cause = diagnosis::Cause::bias;
      finding.since = finding.found = now;
      if (now - start == std::chrono::seconds{205})
        for (finding.device = 0; finding.device < 2; ++finding.device) to.on_finding(finding);
      if (now - start == std::chrono::seconds{340}) {  // a better word for the first
        finding.device = 0;
        finding.found = start + std::chrono::seconds{205};
        to.on_finding(finding);
      }
      finding.until = now;
      finding.device = 1;
      if (now - start == std::chrono::seconds{250}) to.on_finding(finding);
    }
    explicit Findings(endurance::SoakWatch& watch) : to(watch) {}
    endurance::SoakWatch& to;
    Stamp start{};
  };
  constexpr double never_s = 1e9;
  for (const double rest_s : {0.0, 600.0}) {
    endurance::SoakWatch watch(bench, 1, never_s, rest_s);
    Findings findings(watch);
    run(bench, 400, {&findings, &watch});
    EXPECT_EQ(watch.false_alarms(), rest_s > 0 ? 1u : 0u);
    if (rest_s == 0) continue;
    EXPECT_THAT(watch.troubles(), testing::Contains(testing::HasSubstr("still found at 330 s: " +
                                                                       bench.devices[0].name)));
  }
}

/// A fault lasts for a minute at most, and no finding is a false alarm for two minutes more: of
/// each 900 s at least 900 - 300 - 60 - 120 are quiet. Without rests hardly one would be.
TEST(Soak, ARestFollowsEachFiveMinutesWithFaults) {
  const auto bench = rig();
  endurance::SoakWatch watch(bench, 1, 300, 600);
  run(bench, 1800, {&watch});
  EXPECT_GE(watch.quiet_s(), 2 * 420 - 2);
  EXPECT_LE(watch.quiet_s(), 2 * 600);
  EXPECT_GT(watch.faults_set(), 20u) << "18 devices, 600 s, one in 330 s: 33 on average";
  EXPECT_THAT(watch.troubles(), testing::IsEmpty());
}

}  // namespace
}  // namespace soak_test
