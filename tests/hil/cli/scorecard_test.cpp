// What the scorecard makes of two runs, on runs made by hand; then on the shipped rig.
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "hil/cli/scorecard/detection.hpp"
#include "hil/cli/scorecard/heat_map.hpp"
#include "hil/cli/scorecard/scorecard_file.hpp"
#include "hil/cli/scorecard/scorecard_report.hpp"
#include "hil/cli/scorecard/wrong_numbers.hpp"
#include "rig_config/load.hpp"

namespace scorecard_test {

using namespace drydock;
using namespace drydock::cli::scorecard;

constexpr Window window{.warm_up_s = 10, .fault_s = 10, .after_s = 10};

/// A depth sensor at 10 Hz that sinks at 0.5 m/s and is read to 1 cm.
double depth_at(double t_s) { return std::round(50 * t_s) / 100; }

void say(DeviceRecord& device, double valid_s, double received_s, double depth) {
  auto& series = device.series[0];
  series.name = "depth_m";
  series.samples.push_back({valid_s, received_s, depth, device.arrivals.size()});
  device.arrivals.push_back({received_s, 1, 1});
}

RunRecord sound_run() {
  RunRecord run;
  run.devices.resize(1);
  for (int k = 0; k < 300; ++k) say(run.devices[0], 0.1 * k, 0.1 * k + 0.01, depth_at(0.1 * k));
  for (int k = 1; k <= 300; ++k) {
    Look look;
    look.at_s = 0.1 * k;
    run.devices[0].looks.push_back(look);
  }
  return run;
}

rig_config::Rig one_depth_sensor() {
  rig_config::Rig rig;
  rig.devices.resize(1);
  rig.devices[0].name = "depth";
  rig.devices[0].kind = rig_config::DeviceKind::depth;
  return rig;
}

Pair fault(rig_config::FaultKind kind) {
  Pair pair;
  pair.fault.device = "depth";
  pair.fault.kind = kind;
  return pair;
}

Score score(const RunRecord& run, rig_config::FaultKind kind) {
  return score_of(one_depth_sensor(), window, fault(kind), Reference(sound_run()), run);
}

TEST(Reference, AllowsTwiceWhatResolutionPutsANumberOffItsNeighboursLine) {
  // 5.3 cm a sample, read to 1 cm: up to 1 cm off the line of its neighbours.
  RunRecord run = sound_run();
  for (Sample& sample : run.devices[0].series[0].samples)
    sample.value = std::round(53 * sample.valid_s) / 100;
  const Reference reference(std::move(run));
  const auto expected = reference.at(0, 0, 15.05);
  ASSERT_TRUE(expected);
  EXPECT_NEAR(expected->value, 7.9765, 0.01);
  EXPECT_LE(expected->tolerance, 0.021);
  EXPECT_TRUE(reference.sound(0, 0, {15.05, 15.06, 7.98, 0}));
  EXPECT_FALSE(reference.sound(0, 0, {15.05, 15.06, 8.03, 0}));
  EXPECT_FALSE(reference.at(0, 0, 40)) << "it said nothing then";
  EXPECT_NEAR(reference.period_s(0, 0), 0.1, 1e-9);
}

TEST(Score, ARunThatIsTheSameHasNothingWrongAndNothingSeen) {
  const Score s = score(sound_run(), rig_config::FaultKind::flip);
  EXPECT_FALSE(s.detect_s);
  EXPECT_NEAR(s.recover_s.value(), 0.01, 1e-9) << "the first message behind the fault";
  EXPECT_EQ(s.lost, 0);
  EXPECT_EQ(s.wrong, 0u);
  EXPECT_EQ(s.mistimed, 0u);
}

TEST(Score, ANumberThatNobodyMeasuredIsWrong) {
  auto run = sound_run();
  run.devices[0].series[0].samples[150].value += 40;
  const Score s = score(run, rig_config::FaultKind::flip);
  EXPECT_EQ(s.wrong, 1u);
  EXPECT_EQ(s.lies, 0u);
  EXPECT_NE(s.example.find("depth depth_m = 47.5 at 15.000 s, expected 7.5"), std::string::npos)
      << s.example;
}

TEST(Score, ASensorThatIsMadeToMeasureWrongLiesAndItsDriverDoesNot) {
  auto run = sound_run();
  for (std::size_t k = 100; k < 200; ++k) run.devices[0].series[0].samples[k].value += 5;
  const Score s = score(run, rig_config::FaultKind::bias);
  EXPECT_EQ(s.wrong, 0u);
  EXPECT_EQ(s.lies, 100u);
  EXPECT_NEAR(s.recover_s.value(), 0.01, 1e-9);
}

TEST(Score, AMessageThatWasHeldIsMistimedNotWrong) {
  auto run = sound_run();
  for (std::size_t k = 120; k < 140; ++k) {
    run.devices[0].series[0].samples[k].valid_s += 0.5;
    run.devices[0].series[0].samples[k].received_s += 0.5;
    run.devices[0].arrivals[k].received_s += 0.5;
  }
  const Score s = score(run, rig_config::FaultKind::delay);
  EXPECT_EQ(s.wrong, 0u);
  EXPECT_EQ(s.mistimed, 20u);
}

TEST(Score, SilenceIsCountedAndItsEndTimed) {
  RunRecord run;
  run.devices.resize(1);
  for (int k = 0; k < 300; ++k)
    if (k < 100 || k >= 230) say(run.devices[0], 0.1 * k, 0.1 * k + 0.01, depth_at(0.1 * k));
  run.devices[0].changes.push_back({12, device::State::stale});
  run.devices[0].changes.push_back({23.01, device::State::streaming});
  const Score s = score(run, rig_config::FaultKind::hang);
  EXPECT_EQ(s.lost, 130);
  EXPECT_NEAR(s.detect_s.value(), 2, 1e-9);
  EXPECT_EQ(s.sign, "stale");
  EXPECT_NEAR(s.recover_s.value(), 3.01, 1e-9);
}

TEST(Score, ADeviceThatStaysSilentHasNotRecovered) {
  RunRecord run;
  run.devices.resize(1);
  for (int k = 0; k < 100; ++k) say(run.devices[0], 0.1 * k, 0.1 * k + 0.01, depth_at(0.1 * k));
  EXPECT_FALSE(score(run, rig_config::FaultKind::hang).recover_s);
}

TEST(Detection, TheFirstOfAllSignsCountsAndOneOfTheUsualRunDoesNot) {
  auto run = sound_run();
  for (auto& look : run.devices[0].looks) {
    if (look.at_s > 14) look.skipped = 7;
    if (look.at_s > 12.45) look.bad_checksums = 1;
  }
  const auto sign = first_sign(0, window, Reference(sound_run()), run);
  ASSERT_TRUE(sign);
  EXPECT_EQ(sign->what, "bad checksum");
  EXPECT_NEAR(sign->at_s, 12.5, 1e-9);
  EXPECT_FALSE(first_sign(0, window, Reference(run), run));
}

Scorecard card_of(Score s) {
  Scorecard card;
  card.rig = "hand-made";
  card.pairs = 1;
  card.scores = {std::move(s)};
  return card;
}

Score one_score() {
  Score s;
  s.device = "depth";
  s.fault = "flip";
  s.detect_s = 0.12345;
  s.recover_s = 1.5;
  s.wrong = 2;
  return s;
}

TEST(ScorecardFile, IsALineAPairAndItsOwnReference) {
  const auto text = to_json_text(card_of(one_score()));
  EXPECT_NE(text.find("\n{\"device\":\"depth\",\"fault\":\"flip\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"detect_s\":0.123,"), std::string::npos) << text;
  EXPECT_TRUE(differences_from(text, card_of(one_score())).empty());
}

TEST(ScorecardFile, EveryFigureThatIsNotTheSameIsALine) {
  const auto text = to_json_text(card_of(one_score()));
  Score worse = one_score();
  worse.wrong = 3;
  worse.recover_s.reset();
  EXPECT_EQ(differences_from(text, card_of(worse)),
            (std::vector<std::string>{"depth flip: recover_s: expected 1.5, got null",
                                      "depth flip: wrong: expected 2, got 3"}));
  Score other = one_score();
  other.fault = "drop";
  EXPECT_EQ(differences_from(text, card_of(other)),
            (std::vector<std::string>{"depth drop: not in the reference",
                                      "depth flip: only in the reference"}));
}

TEST(ScorecardFile, AReferenceOfAnotherSeedIsRefusedInALine) {
  const auto text = to_json_text(card_of(one_score()));
  auto card = card_of(one_score());
  card.seed = 7;
  EXPECT_THROW(differences_from(text, card), std::runtime_error);
  EXPECT_THROW(differences_from("[]", card), std::runtime_error);
  EXPECT_THROW(differences_from("{\"drydock_scorecard\":1}", card), std::runtime_error);
}

TEST(HeatMap, EveryCellHasItsNumberAndTextIsEscaped) {
  HeatMap map{
      "a<b",
      {{"p", {"x", "y"}}},
      {{"layer", {}}, {"row", {{"1.5", Tone::shade, 1, ""}, {"not", Tone::alarm, 0, "why & how"}}}},
      40};
  const auto svg = to_svg(map);
  EXPECT_NE(svg.find("a&lt;b"), std::string::npos);
  EXPECT_NE(svg.find(">1.5</text>"), std::string::npos);
  EXPECT_NE(svg.find("why &amp; how"), std::string::npos);
  EXPECT_NE(svg.find("#084081"), std::string::npos) << "the darkest shade";
}

// ------------------------------------------------------------------------ the shipped rig

rig_config::Rig demo() {
  return rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value();
}

std::string json_of(Options options) {
  const auto file = std::filesystem::temp_directory_path() /
                    ("drydock-scorecard-" + std::to_string(::getpid()) + ".json");
  options.json = file.string();
  std::FILE* nowhere = std::fopen("/dev/null", "w");
  EXPECT_EQ(run_scorecard(demo(), options, nowhere, nowhere), 0);
  std::fclose(nowhere);
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  std::filesystem::remove(file);
  return text.str();
}

TEST(Scorecard, IsTheSameToTheLastByteWhateverTheNumberOfThreads) {
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

TEST(Scorecard, PairsThatADeviceCannotHaveAreNotTried) {
  const auto pairs = pairs_of(demo(), {}, {"imu", "dvl"}, {"unplug", "bias"});
  std::vector<std::string> names;
  for (const auto& pair : pairs) names.push_back(pair.fault.device + " " + pair.label);
  EXPECT_EQ(names, (std::vector<std::string>{"dvl bias", "dvl unplug", "imu bias rate_degps",
                                             "imu bias specific_force_mps2"}));
  EXPECT_THROW(pairs_of(demo(), {}, {"sonar"}, {}), std::runtime_error);
  EXPECT_THROW(pairs_of(demo(), {}, {}, {"gremlin"}), std::runtime_error);
}

TEST(Scorecard, NoDeviceWithAChecksumGivesAWrongNumberForDamagedBytes) {
  const auto rig = demo();
  const Window short_window{.warm_up_s = 20, .fault_s = 20, .after_s = 5};
  auto sound = rig;
  sound.faults.clear();
  const Reference reference(record_run(sound, short_window.run_s()));
  for (const auto& pair :
       pairs_of(rig, short_window, {"dvl", "emlog", "gnss"},
                {"flip", "truncate", "bad-checksum", "garbage", "duplicate", "wrong-baud"})) {
    auto faulty = rig;
    faulty.faults = {pair.fault};
    const Score s =
        score_of(rig, short_window, pair, reference, record_run(faulty, short_window.run_s()));
    EXPECT_EQ(s.wrong, 0u) << s.device << " " << s.fault << ": " << s.example;
    EXPECT_TRUE(s.recover_s) << s.device << " " << s.fault;
  }
}

}  // namespace scorecard_test
