// What the diagnosis said about one fault, judged on findings that were made by hand.
#include "hil/scorecard/finding_score.hpp"

#include <gtest/gtest.h>

#include "hil/scorecard/scorecard_file.hpp"
#include "hil/scorecard/scorecard_report.hpp"

namespace finding_score_test {

using namespace drydock;
using namespace drydock::scorecard;
using diagnosis::Cause;
using Names = std::vector<std::string>;

constexpr Window window{.warm_up_s = 10, .fault_s = 10, .after_s = 10};
constexpr std::size_t dvl = 0, gnss = 1, depth = 2;

/// A DVL on its own line; receiver and pressure sensor share a bus.
rig_config::Rig three_devices() {
  rig_config::Rig rig;
  rig.devices.resize(3);
  rig.devices[dvl].name = "dvl";
  rig.devices[gnss].name = "gnss";
  rig.devices[depth].name = "depth";
  rig.devices[dvl].link = "pty:dvl";
  rig.devices[gnss].link = rig.devices[depth].link = "can:auto";
  return rig;
}

FindingAt found(std::size_t device, Cause cause, double from_s, double until_s) {
  FindingAt finding;
  finding.device = device;
  finding.cause = cause;
  finding.found_s = from_s;
  finding.until_s = until_s;
  return finding;
}

FindingScore judged(const std::vector<FindingAt>& findings, const char* device,
                    rig_config::FaultKind kind, const char* also = nullptr,
                    const std::vector<FindingAt>& sound = {}) {
  RunRecord run;
  run.devices.resize(3);
  run.findings = findings;
  Pair pair;
  pair.fault.device = device;
  pair.fault.kind = kind;
  if (also != nullptr) pair.also.emplace().device = also;
  return judge_findings(three_devices(), window, pair, sound, run);
}

TEST(FindingScore, NamesTheSoundDevicesThatAreAccusedEachCauseOnce) {
  const auto score = judged({found(gnss, Cause::drift, 5, 8), found(dvl, Cause::bias, 11, 22),
                             found(gnss, Cause::bias, 12, 14), found(gnss, Cause::bias, 15, 19),
                             found(gnss, Cause::delay, 26, 29), found(depth, Cause::bias, 18, 20)},
                            "dvl", rig_config::FaultKind::bias);
  EXPECT_TRUE(score.right_device);
  EXPECT_EQ(score.before, 1u);
  EXPECT_EQ(score.others, (Names{"gnss delay", "gnss bias", "depth bias"}))
      << "in the settling as well, and not what came before the fault";
}

TEST(FindingScore, HoldsADeviceOnAHarmedBusOrWithAFaultOfItsOwnForUnsound) {
  const std::vector<FindingAt> findings{found(depth, Cause::bus_load, 11, 15),
                                        found(gnss, Cause::bus_load, 11, 15)};
  EXPECT_TRUE(judged(findings, "depth", rig_config::FaultKind::bus_load).others.empty());
  EXPECT_EQ(judged(findings, "depth", rig_config::FaultKind::bias).others, Names{"gnss bus-load"});
  EXPECT_TRUE(judged(findings, "depth", rig_config::FaultKind::bias, "gnss").others.empty());
}

TEST(FindingScore, HoldsForTrueWhatTheRunWithoutFaultsSaysOfBedAndSky) {
  const std::vector<FindingAt> bed{found(dvl, Cause::bottom_lost, 5, 12),
                                   found(gnss, Cause::bias, 6, 8)};
  auto with_fault = bed;
  with_fault.push_back(found(depth, Cause::bias, 13, 20));
  with_fault.push_back(found(dvl, Cause::bottom_lost, 14, 20));
  const auto score = judged(with_fault, "depth", rig_config::FaultKind::bias, nullptr, bed);
  EXPECT_EQ(score.before, 1u) << "the receiver's";
  EXPECT_TRUE(score.right_device);
  EXPECT_EQ(score.found_s, 3);
  EXPECT_EQ(score.others, Names{"dvl bottom-lost"}) << "that of the run with the fault alone";
}

TEST(FindingScore, TellsTheAccusedInTableFileAndPage) {
  Scorecard card;
  card.rig = "hand-made";
  card.pairs = 1;
  Score score;
  score.device = "dvl";
  score.fault = "bias";
  score.finding.others = {"gnss delay", "depth bias"};
  card.scores = {score};
  EXPECT_NE(to_json_text(card).find(R"("others_accused":["gnss delay","depth bias"])"),
            std::string::npos);
  const auto text = to_text(card);
  EXPECT_NE(text.find("gnss delay, depth bias"), std::string::npos) << text;
  EXPECT_NE(text.find("sound devices accused beside it: in 1 pairs"), std::string::npos) << text;
  EXPECT_NE(to_html(card).find("dvl bias: gnss delay, depth bias"), std::string::npos);
}

}  // namespace finding_score_test
