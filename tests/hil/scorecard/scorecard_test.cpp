// The scorecard of the shipped rig.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "hil/scorecard/score_bytes.hpp"
#include "hil/scorecard/scorecard_report.hpp"
#include "hil/scorecard/wrong_numbers.hpp"
#include "rig_config/load.hpp"

namespace scorecard_test {

using namespace drydock;
using namespace drydock::scorecard;

rig_config::Rig demo() {
  return rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value();
}

std::string json_of(Options options, const rig_config::Rig& rig = demo()) {
  const auto file = std::filesystem::temp_directory_path() /
                    ("drydock-scorecard-" + std::to_string(::getpid()) + ".json");
  options.json = file.string();
  std::FILE* nowhere = std::fopen("/dev/null", "w");
  EXPECT_EQ(run_scorecard(rig, options, nowhere, nowhere), 0);
  std::fclose(nowhere);
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  std::filesystem::remove(file);
  return text.str();
}

TEST(Scorecard, IsTheSameToTheLastByteWhateverTheNumberOfProcesses) {
  Options options;
  options.faults = {"flip", "hang"};
  options.devices = {"dvl", "gnss", "depth"};
  options.window = {.warm_up_s = 5, .fault_s = 5, .after_s = 5};
  options.jobs = 1;
  const auto alone = json_of(options);
  options.jobs = 3;
  EXPECT_EQ(alone, json_of(options));
  EXPECT_EQ(std::ranges::count(alone, '\n'), 2 + 6 + 1);
}

TEST(Scorecard, OfAFlightFitsBetweenItsStartAndItsImpact) {
  Options options;
  options.faults = {"off"};
  options.devices = {"gnss"};
  const auto rocket =
      rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/sounding-rocket.toml").value();
  // The flight lasts 86.8 s, the usual run 150 s.
  const auto card = json_of(options, rocket);
  EXPECT_NE(card.find("\"warm_up_s\":43.0,\"fault_s\":17.0,\"after_s\":26.0"), card.npos) << card;
}

TEST(Scorecard, PairsThatADeviceCannotHaveAreNotTried) {
  const auto pairs = pairs_of(demo(), {}, {"imu", "dvl"}, {"unplug", "bias"});
  std::vector<std::string> names;
  for (const auto& pair : pairs) names.push_back(pair.fault.device + " " + pair.label);
  EXPECT_EQ(names, (std::vector<std::string>{"dvl bias", "dvl unplug", "imu bias rate_degps",
                                             "imu bias specific_force_mps2"}));
  EXPECT_THROW(pairs_of(demo(), {}, {"sonar"}, {}), std::runtime_error);
  EXPECT_THROW(fault_named(demo(), {}, "dvl"), std::runtime_error);
  EXPECT_THROW(fault_named(demo(), {}, "dvl:gremlin"), std::runtime_error);
  EXPECT_THROW(pairs_of(demo(), {}, {}, {"gremlin"}), std::runtime_error);
}

TEST(Pairs, WithThreeTimesTheAmountKeepTheirLimits) {
  const auto words = [](const char* text) {
    return scaled(fault_named(demo(), {}, text), 3).words;
  };
  EXPECT_EQ(words("dvl:bias"), "dvl: bias, velocity_mps = 0.9");
  EXPECT_EQ(words("dvl:delay"), "dvl: delay, seconds = 1.5");
  EXPECT_EQ(words("depth:drift"), "depth: drift, pressure_pa = 60000");
  EXPECT_EQ(scaled(fault_named(demo(), {}, "depth:drift"), 3).within_s, 20);
  EXPECT_EQ(words("dvl:slow"), "dvl: slow, times = 4") << "1 is no fault";
  EXPECT_EQ(words("dvl:unplug"), "dvl: unplug") << "has no amount";
  const auto drop = scaled(fault_named(demo(), {}, "dvl:drop"), 30);
  EXPECT_EQ(drop.words, "dvl: drop, probability = 1");
}

TEST(Pairs, WithAFractionOfTheAmountHaveWholeBytesAndAtLeastOne) {
  const auto bytes = [](double times) {
    return scaled(fault_named(demo(), {}, "dvl:garbage"), times).words;
  };
  EXPECT_EQ(bytes(0.61).substr(0, 24), "dvl: garbage, bytes = 10") << "of 16";
  EXPECT_EQ(bytes(0.01).substr(0, 23), "dvl: garbage, bytes = 1");
}

TEST(Recording, ThatGoesOnFromASharedBeginningIsTheRunAlone) {
  const Window shortest{.warm_up_s = 5, .fault_s = 5, .after_s = 5};
  auto rig = demo();
  rig.faults.clear();
  Recording sound(rig);
  const Reference reference(sound.run_to(shortest.run_s()));
  const auto pairs = pairs_of(rig, shortest, {"dvl", "actuators"},
                              {"drop", "jitter", "off", "unplug", "babbling", "bus-off", "bias"});
  ASSERT_EQ(pairs.size(), 12u);
  for (const auto& pair : pairs) {
    auto faulty = rig;
    faulty.faults = {pair.fault};
    const Score alone =
        score_of(rig, shortest, pair, reference, record_run(faulty, shortest.run_s()));
    Recording shared(rig, sound);
    shared.run_before(shortest.warm_up_s);
    shared.set(pair.fault);
    const Score of_shared =
        score_of(rig, shortest, pair, reference, shared.run_to(shortest.run_s()));
    EXPECT_EQ(to_bytes(alone), to_bytes(of_shared)) << alone.device << " " << alone.fault;
  }
}

TEST(Scorecard, NoDeviceWithAChecksumGivesAWrongNumberForDamagedBytes) {
  const auto rig = demo();
  const Window short_window{.warm_up_s = 20, .fault_s = 20, .after_s = 5};
  auto sound = rig;
  sound.faults.clear();
  const Reference reference(record_run(sound, short_window.run_s()));
  for (const auto& pair : pairs_of(rig, short_window, {"dvl", "emlog", "gnss"},
                                   {"flip", "flip-header", "truncate", "bad-checksum", "garbage",
                                    "duplicate", "wrong-baud"})) {
    auto faulty = rig;
    faulty.faults = {pair.fault};
    const Score s =
        score_of(rig, short_window, pair, reference, record_run(faulty, short_window.run_s()));
    EXPECT_EQ(s.wrong, 0u) << s.device << " " << s.fault << ": " << s.example;
    EXPECT_EQ(s.mistimed, 0u) << s.device << " " << s.fault;
    EXPECT_TRUE(s.recover_s) << s.device << " " << s.fault;
  }
}

/// What one wrong device does to the checks of the others is none of their faults.
TEST(Diagnosis, AccusesNoSoundDeviceBesideTheOneThatIsWrong) {
  const auto rig = demo();
  const Window window;
  auto sound = rig;
  sound.faults.clear();
  const Reference reference(record_run(sound, window.run_s()));
  auto pairs = pairs_of(rig, window, {"dvl"}, {"wrong", "spike", "stuck", "bias", "noise"});
  for (const char* burst : {"imu", "actuators"})
    for (const auto& pair : pairs_of(rig, window, {burst}, {"burst"})) pairs.push_back(pair);
  for (const auto& pair : pairs_of(rig, window, {"depth"}, {"address-stolen"}))
    pairs.push_back(pair);
  ASSERT_EQ(pairs.size(), 8u);
  for (const auto& pair : pairs) {
    auto faulty = rig;
    faulty.faults = {pair.fault};
    const Score s = score_of(rig, window, pair, reference, record_run(faulty, window.run_s()));
    EXPECT_TRUE(s.finding.right_device) << s.device << " " << s.fault;
    EXPECT_EQ(s.finding.others, std::vector<std::string>{}) << s.device << " " << s.fault;
  }
}

}  // namespace scorecard_test
