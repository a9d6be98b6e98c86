// When faults are over, all that is found of them is over soon, and nothing new is found: nothing
// that was learned of a device in its fault stays.
#include <gtest/gtest.h>

#include "hil/bench/run.hpp"
#include "rig_config/load.hpp"

namespace aftermath_test {
namespace {

using namespace drydock;

/// Several at once, and one after the other on a device that begins to learn again. All end before
/// 483 s.
constexpr const char* faults = R"(
[[fault]]
device = "gauge"
fault = "wrong"
pressure_pa = 20000
start_s = 369.1
for_s = 51.3

[[fault]]
device = "gauge"
fault = "bias"
pressure_pa = 20000
start_s = 432
for_s = 50.5

[[fault]]
device = "mti"
fault = "drop"
start_s = 400
for_s = 82
probability = 0.13

[[fault]]
device = "depth"
fault = "flip"
start_s = 420
for_s = 40
probability = 0.4

[[fault]]
device = "pd6"
fault = "noise"
times = 13
start_s = 420
for_s = 58

[[fault]]
device = "pd0"
fault = "noise"
times = 15
start_s = 430
for_s = 50
)";

TEST(Aftermath, OfFaultsThatAreOverEndsWithinTwoMinutes) {
  constexpr double end_s = 483, recovers_within_s = 120;
  auto rig = rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/soak.toml").value();
  rig.faults = rig_config::load_faults_text(faults, "test").value();
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    rig.seed = seed;
    bench::RunOptions options;
    options.duration_s = 700;
    options.quiet = true;
    const auto summary = bench::run_lockstep(rig, options);
    EXPECT_GT(summary.findings.size(), 5u) << "each device has one at least";
    for (const auto& finding : summary.findings)
      EXPECT_LT(finding.until_s.value_or(1e9), end_s + recovers_within_s)
          << "seed " << seed << ": " << finding.device << " " << finding.cause << " since "
          << finding.since_s << " s";
  }
}

/// Bits of the turns of a shaft flip behind the CRC of its bus: for seconds it tells wild turns.
TEST(Aftermath, OfTurnsThatWereDamagedIsNoWrongLawOfTheShaft) {
  constexpr double end_s = 425, recovers_within_s = 120;
  auto rig = rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/soak.toml").value();
  rig.faults = rig_config::load_faults_text(
                   "[[fault]]\ndevice = \"actuators\"\nfault = \"flip\"\nprobability = 0.34\n"
                   "start_s = 400\nfor_s = 25\n",
                   "test")
                   .value();
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    rig.seed = seed;
    bench::RunOptions options;
    options.duration_s = 900;
    options.quiet = true;
    const auto summary = bench::run_lockstep(rig, options);
    EXPECT_FALSE(summary.findings.empty());
    for (const auto& finding : summary.findings)
      EXPECT_LT(finding.until_s.value_or(1e9), end_s + recovers_within_s)
          << "seed " << seed << ": " << finding.device << " " << finding.cause << " since "
          << finding.since_s << " s";
  }
}

}  // namespace
}  // namespace aftermath_test
