// A rig's [[expect]] blocks in lockstep: what passes, what fails and why, and the JUnit file as
// another program's XML parser reads it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>

#include "hil/bench/run.hpp"
#include "hil/summary/judge.hpp"
#include "hil/summary/junit.hpp"
#include "rig_config/load.hpp"

namespace drydock::summary::expect_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string text_of(const std::string& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// A shipped rig with `expects` in place of its own [[expect]] blocks.
rig_config::Rig shipped(const std::string& name, const std::string& expects) {
  const std::string path = DRYDOCK_SOURCE_DIR "/rig_config/rigs/" + name + ".toml";
  const std::string text = text_of(path);
  return rig_config::load_rig_text(text.substr(0, text.find("[[expect]]")) + expects, path).value();
}

Summary run_for(const rig_config::Rig& rig, double duration_s) {
  testing::internal::CaptureStdout();
  bench::RunOptions options;
  options.duration_s = duration_s;
  auto summary = bench::run_lockstep(rig, options);
  testing::internal::GetCapturedStdout();
  return summary;
}

std::vector<std::string> lines_of(const Summary& summary) {
  std::istringstream text(to_text(summary.verdicts));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

/// The exit code and the output of the command with --speed max.
struct Outcome {
  int exit_code = -1;
  std::string output;
};
Outcome command(const rig_config::Rig& rig, bench::RunOptions options) {
  options.lockstep = true;
  testing::internal::CaptureStdout();
  const int code = bench::run(rig, options);
  return {code, testing::internal::GetCapturedStdout()};
}

/// What Python's parser reads from a JUnit file, one line per testcase.
std::string read_by_python(const std::string& path) {
  const std::string command =
      "python3 -c \"import sys, xml.etree.ElementTree as E\n"
      "root = E.parse(sys.argv[1]).getroot()\n"
      "for s in root.iter('testsuite'):\n"
      "  print(s.get('name'), s.get('tests'), s.get('failures'), s.get('errors'))\n"
      "for c in root.iter('testcase'):\n"
      "  print(c.get('classname'), '|', c.get('name'), '|', c.get('line'), '|',\n"
      "        *[k.tag + ' ' + (k.get('message') or k.text) for k in c])\" " +
      path + " 2>&1";
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string out;
  std::array<char, 4096> chunk{};
  while (const auto n = std::fread(chunk.data(), 1, chunk.size(), pipe))
    out.append(chunk.data(), n);
  EXPECT_EQ(pclose(pipe), 0) << out;
  return out;
}

struct TemporaryFile {
  std::string path = (std::filesystem::temp_directory_path() / "drydock-expect-XXXXXX").string();
  TemporaryFile() { close(mkstemp(path.data())); }
  ~TemporaryFile() { std::filesystem::remove(path); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
};

TEST(Expectations, OfTheDemoAreMet) {
  const auto rig = rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value();
  ASSERT_FALSE(rig.expects.empty());
  for (const auto& verdict : run_for(rig, 5).verdicts)
    EXPECT_TRUE(verdict.passed) << verdict.subject << " " << verdict.what << verdict.measured;
}

TEST(Expectations, AreLinesWithWhatWasMeasuredAndWhatWasAllowed) {
  const auto summary = run_for(shipped("demo",
                                       "[[expect]]\ndevice = \"dvl\"\nstate = \"streaming\"\n"
                                       "bad_checksums_max = 0\nmessages_min = 1000\n"),
                               10);
  EXPECT_THAT(lines_of(summary),
              testing::UnorderedElementsAre(
                  "PASS dvl state: streaming, expected streaming",
                  "PASS dvl bad_checksums: 0, expected at most 0",
                  testing::MatchesRegex("FAIL dvl messages: [0-9]+, expected at least 1000"),
                  "2 of 3 expectations met"));
}

/// A hang of the log from 5 s to 15 s, in a run of 30 s, is a finding of the log alone.
TEST(Expectations, FindingsAreCountedForADeviceAndForTheRigFromTheirTimeOn) {
  auto rig = shipped("demo",
                     "[[expect]]\ndevice = \"emlog\"\nafter_s = 6\nfindings_max = 0\n"
                     "[[expect]]\ndevice = \"dvl\"\nafter_s = 6\nfindings_max = 0\n"
                     "[[expect]]\nafter_s = 6\nfindings_max = 0\n"
                     "[[expect]]\nafter_s = 25\nfindings_max = 0\n"
                     "[[expect]]\nafter_s = 40\nfindings_max = 0\n");
  rig.faults =
      rig_config::load_faults_text(
          "[[fault]]\ndevice = \"emlog\"\nfault = \"hang\"\nstart_s = 5\nfor_s = 10\n", "t")
          .value();
  const auto summary = run_for(rig, 30);
  EXPECT_THAT(lines_of(summary),
              ElementsAre(testing::StartsWith("FAIL emlog findings: 1 (emlog: silent from "),
                          "PASS dvl findings: 0, expected at most 0",
                          testing::StartsWith("FAIL rig findings: 1 (emlog: silent from "),
                          "PASS rig findings: 0, expected at most 0",
                          testing::StartsWith("FAIL rig findings: none: the run ended at 30.0 s"),
                          "2 of 5 expectations met"));
  EXPECT_THAT(to_text(summary), HasSubstr("finding emlog: silent from "));
  const auto json = nlohmann::json::parse(to_json(summary));
  const auto& finding = json["findings"].back();
  EXPECT_EQ(finding["device"], "emlog");
  EXPECT_EQ(finding["cause"], "silent");
  EXPECT_NEAR(finding["since_s"].get<double>(), 5, 0.6) << "its last message, at 2 Hz";
  EXPECT_THAT(to_html(summary), HasSubstr("emlog: <span class=bad>silent</span> from "));
}

TEST(Findings, OfAHealthyDeviceAreNone) {
  Summary summary;
  EXPECT_THAT(to_text(summary), HasSubstr("no findings\n"));
  EXPECT_EQ(nlohmann::json::parse(to_json(summary))["findings"].dump(), "[]");
}

TEST(Expectations, EveryFigureOfTheSchemaIsInTheSummary) {
  const auto schema = nlohmann::json::parse(rig_config::schema_text());
  const auto& expect = schema["definitions"]["expect"];
  for (const auto& [key, rule] : expect["properties"].items()) {
    if (key == "device" || key == "estimator" || key == "after_s" || key == "state") continue;
    rig_config::ExpectConfig one;
    (expect["else"]["properties"].contains(key) ? one.estimator : one.device) = "x";
    const bool ranged = rule["$ref"] == "#/definitions/bounds";
    one.figures.push_back({ranged ? key : key.substr(0, key.size() - 4), {}, 1});
    EXPECT_NO_THROW(judge(one, {})) << key;
  }
}

TEST(Expectations, AskForTheShareOfEstimatesThatSayThatTheyAreValid) {
  // From the start the attitude is not known to .35 rad, so the first estimates are not valid.
  const auto rig = shipped("demo",
                           "[[expect]]\nestimator = \"leveling\"\nvalid_share_min = 1\n"
                           "[[expect]]\nestimator = \"leveling\"\nafter_s = 10\n"
                           "valid_share_min = 1\n");
  const auto summary = run_for(rig, 20);
  ASSERT_EQ(summary.verdicts.size(), 2u);
  EXPECT_FALSE(summary.verdicts[0].passed);
  EXPECT_GT(summary.estimators[0].valid_share.value(), 0.8);
  EXPECT_TRUE(summary.verdicts[1].passed) << summary.verdicts[1].measured;
}

TEST(Expectations, AfterSomeTimeCountOnlyWhatComesLater) {
  const auto rig = shipped("demo",
                           "[[expect]]\nestimator = \"leveling\"\nestimates_min = 1\n"
                           "roll_rms_deg_max = 90\nnis = [0, 9]\n"
                           "[[expect]]\nestimator = \"leveling\"\nafter_s = 10\n"
                           "estimates_min = 1\nroll_rms_deg_max = 90\nnis = [0, 9]\n"
                           "[[expect]]\ndevice = \"dvl\"\nafter_s = 15\nmessages_min = 1\n");
  const auto summary = run_for(rig, 20);
  const auto measured = [&](std::size_t i, const std::string& what) {
    const auto& figures = rig.expects[i].figures;
    std::size_t first = 0;
    for (std::size_t block = 0; block < i; ++block) first += rig.expects[block].figures.size();
    const auto of_block = std::span(summary.verdicts).subspan(first, figures.size());
    return std::stod(std::ranges::find(of_block, what, &Verdict::what)->measured);
  };
  const auto& e = summary.estimators[0];
  EXPECT_NEAR(measured(0, "estimates"), static_cast<double>(e.estimates), 1);
  EXPECT_NEAR(measured(1, "estimates"), 1000, 25);
  EXPECT_NEAR(measured(1, "roll_rms_deg"), e.after_10_s->roll_rms_deg, 1e-5);
  EXPECT_NE(measured(0, "roll_rms_deg"), measured(1, "roll_rms_deg"));
  EXPECT_NE(measured(0, "nis"), measured(1, "nis"));
  EXPECT_NEAR(measured(2, "messages"), 25, 1);
}

TEST(Expectations, ThatBeginAfterTheRunFail) {
  const auto rig = shipped("demo",
                           "[[expect]]\ndevice = \"dvl\"\nafter_s = 30\nstate = \"streaming\"\n"
                           "reopens_max = 0\n");
  EXPECT_THAT(
      lines_of(run_for(rig, 5)),
      testing::Contains("FAIL dvl state: none: the run ended at 5.0 s, before after_s = 30, "
                        "expected streaming"));
}

TEST(Expectations, ThatBeginWithTheEndHaveNothingToJudge) {
  const auto rig = shipped("demo", "[[expect]]\ndevice = \"dvl\"\nafter_s = 5\nreopens_max = 0\n");
  EXPECT_THAT(lines_of(run_for(rig, 5)),
              testing::Contains("FAIL dvl reopens: none: the run ended at 5.0 s, with after_s = 5, "
                                "expected at most 0"));
  EXPECT_THAT(lines_of(run_for(rig, 6)),
              testing::Contains("PASS dvl reopens: 0, expected at most 0"));
}

/// The recording has three seconds of sentences and then nothing.
TEST(Expectations, OfARecordingThatEndsFailWithTheTimeOfItsEnd) {
  auto rig = shipped("demo",
                     "[[expect]]\ndevice = \"emlog\"\nafter_s = 2.5\nstate = \"streaming\"\n"
                     "[[expect]]\ndevice = \"dvl\"\nafter_s = 2.5\nstate = \"streaming\"\n");
  rig.devices[1].link =
      "file:" DRYDOCK_SOURCE_DIR "/fixtures/nmea0183/golden.nmea?speed=1&baud=4800";
  const auto summary = run_for(rig, 20);
  ASSERT_EQ(summary.verdicts.size(), 2u);
  EXPECT_FALSE(summary.verdicts[0].passed);
  EXPECT_THAT(summary.verdicts[0].measured, testing::ContainsRegex("^closed at [0-9.]+ s"));
  EXPECT_TRUE(summary.verdicts[1].passed) << summary.verdicts[1].measured;
}

TEST(Expectations, OfErrorsFailWhereThereIsNoTruth) {
  summary::Outcome found;
  found.estimator = EstimatorSummary{};
  found.estimator->estimates = 5;
  found.estimator->nis = 1.25;
  rig_config::ExpectConfig expect;
  expect.estimator = "ins";
  expect.figures = {{"nees", {0, 2}}, {"position_rms_m", {0, 2}}, {"nis", {0.5, 2}}};
  const auto verdicts = judge(expect, found);
  EXPECT_FALSE(verdicts[0].passed);
  EXPECT_EQ(verdicts[0].measured, "none: no estimate has a truth to compare with");
  EXPECT_FALSE(verdicts[1].passed);
  EXPECT_TRUE(verdicts[2].passed) << "innovations need no truth";
}

TEST(Expectations, OfTheCommandLineAreJudgedAsThoseOfTheFile) {
  bench::RunOptions options;
  options.duration_s = 5;
  options.expect_streaming = true;
  options.expect_rms_deg = 1e-6;
  const auto outcome = command(shipped("demo", ""), options);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("PASS actuators state: streaming, expected streaming\n"));
  EXPECT_THAT(outcome.output, HasSubstr("PASS leveling estimates: "));
  EXPECT_THAT(outcome.output, HasSubstr("FAIL leveling roll_rms_deg: "));
  EXPECT_THAT(outcome.output, HasSubstr("7 of 9 expectations met\n"));
}

TEST(Expectations, InAJUnitFileAreTestcasesForAnotherParser) {
  const TemporaryFile file;
  bench::RunOptions options;
  options.duration_s = 5;
  options.junit = file.path;
  const auto outcome = command(
      shipped("demo",
              "[[expect]]\ndevice = \"emlog\"\nrate_hz = [7, 9]\n[[expect]]\ndevice = \"dvl\"\n"
              "reopens_max = 0\n"),
      options);
  EXPECT_EQ(outcome.exit_code, 1);
  const auto read = read_by_python(file.path);
  EXPECT_THAT(read, testing::StartsWith("demo 2 1 0\n"));
  EXPECT_THAT(read,
              testing::ContainsRegex(
                  "demo.emlog \\| rate_hz: 7 to 9 \\| [0-9]+ \\| failure 2[0-9.]*, expected 7"));
  EXPECT_THAT(read, testing::ContainsRegex("demo.dvl \\| reopens: at most 0 \\| [0-9]+ \\| "
                                           "system-out 0"));
}

TEST(Expectations, AreInAJUnitFileEvenIfTheRunCannotBegin) {
  const TemporaryFile file;
  auto rig = shipped("demo", "");
  rig.devices[0].link = "serial:/dev/<none>\"&?baud=115200";
  bench::RunOptions options;
  options.junit = file.path;
  options.lockstep = true;
  EXPECT_THROW(bench::run(rig, options), std::runtime_error);
  const auto read = read_by_python(file.path);
  EXPECT_THAT(read, testing::StartsWith("demo 1 0 1\n"));
  EXPECT_THAT(read, HasSubstr("serial:/dev/<none>\"&?baud=115200 is real hardware"));
}

}  // namespace
}  // namespace drydock::summary::expect_test
