#include <gmock/gmock.h>

#include <unistd.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "drivers/recordings/record/recording.hpp"
#include "hil/bench/run.hpp"
#include "hil/diagnose/diagnose.hpp"
#include "hil/diagnose/examination.hpp"
#include "hil/diagnose/sources.hpp"
#include "hil/replay/replay_bench.hpp"
#include "hil/replay/rigs/recorded_rig.hpp"
#include "rig_config/load.hpp"

namespace drydock::diagnose {
namespace recording_test {

using testing::Each;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

namespace fs = std::filesystem;

/// A folder of its own for each test.
class Diagnosing : public testing::Test {
 protected:
  Diagnosing() { fs::create_directories(folder_); }
  ~Diagnosing() override { fs::remove_all(folder_); }

  /// 60 s of the demo rig with these faults, in virtual time.
  std::string recorded(const std::string& faults) const {
    auto rig = rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value();
    if (!faults.empty()) rig.faults = rig_config::load_faults_text(faults, "f.toml").value();
    bench::RunOptions options;
    options.duration_s = 60;
    options.quiet = true;
    options.record.path = folder_ / "dive.mcap";
    options.record.overwrite = true;
    bench::run_lockstep(rig, options);
    return options.record.path;
  }

  const fs::path folder_ =
      fs::temp_directory_path() / ("drydock-diagnose-" + std::to_string(::getpid()));
};

/// The exit code of a command that tells this outcome, and what it prints.
std::pair<int, std::string> told(const Outcome& outcome, const DiagnoseOptions& options = {}) {
  testing::internal::CaptureStdout();
  const int code = tell(outcome, options, stdout);
  return {code, testing::internal::GetCapturedStdout()};
}

TEST_F(Diagnosing, ARecordingNamesTheDeviceThatFellSilentAndNoOther) {
  const auto outcome = read_recording(
      recorded("[[fault]]\ndevice = \"emlog\"\nfault = \"hang\"\nstart_s = 20\nfor_s = 15\n"));
  ASSERT_THAT(outcome.findings, Not(IsEmpty()));
  EXPECT_THAT(outcome.findings, Each(Field(&diagnosis::FindingAccount::device, "emlog")));
  const auto& finding = outcome.findings.front();
  EXPECT_EQ(finding.cause, "silent");
  EXPECT_NEAR(finding.since_s, 20, 0.6) << "its last message, at 2 Hz";
  ASSERT_TRUE(finding.until_s);
  EXPECT_GE(*finding.until_s, 35);
  EXPECT_LE(*finding.until_s, 41) << "the judge remembers a sign for 5 s";
  const auto [code, text] = told(outcome);
  EXPECT_EQ(code, 1);
  EXPECT_THAT(text, HasSubstr("emlog: silent from "));
  EXPECT_THAT(text, HasSubstr("  try: look at the sensor's power and cable\n"));
}

/// The log is the second device of the rig and the only one that plays.
TEST_F(Diagnosing, APartOfARecordingNamesItsOwnDevice) {
  auto recording = record::Recording::open(
      recorded("[[fault]]\ndevice = \"emlog\"\nfault = \"hang\"\nstart_s = 20\nfor_s = 15\n"));
  ASSERT_TRUE(recording);
  const replay::RecordedRig rig(*recording);
  boost::asio::io_context io;
  replay::Pace pace(io, 0);
  record::Selection part;
  part.only = {"emlog"};
  replay::ReplayBench bench(*recording, rig.rig(), part, {});
  Examination examination(rig.rig(), bench.start(), 60);
  examination.follow(bench.followers(), bench.devices());
  bench.play(pace, [](double) { return true; });
  const auto outcome = examination.result("part", bench.start() + bench.played(), false);
  ASSERT_THAT(outcome.findings, Not(IsEmpty()));
  EXPECT_THAT(outcome.findings, Each(Field(&diagnosis::FindingAccount::device, "emlog")));
}

/// The strings of a message stand in its bytes as they are.
TEST_F(Diagnosing, ARunsFindingsAreInItsRecordingOnDiagnostics) {
  auto recording = record::Recording::open(
      recorded("[[fault]]\ndevice = \"emlog\"\nfault = \"hang\"\nstart_s = 20\nfor_s = 8\n"));
  ASSERT_TRUE(recording);
  int found = 0, over = 0;
  while (const auto event = recording->next()) {
    const auto* message = std::get_if<record::Understood>(&*event);
    if (message == nullptr || message->channel->topic != "/diagnostics") continue;
    const std::string bytes(message->cdr.begin(), message->cdr.end());
    if (bytes.find("emlog/silent") == std::string::npos) continue;
    ++(bytes.find("no longer silent") == std::string::npos ? found : over);
  }
  EXPECT_GE(found, 6) << "once a second, from 22 s to 28 s at least";
  EXPECT_LE(found, 13);
  EXPECT_EQ(over, 1);
}

TEST_F(Diagnosing, AHealthyRecordingHasNoFindingAndSaysWhatItCouldNotHaveSeen) {
  const auto outcome = read_recording(recorded(""));
  const auto [code, text] = told(outcome);
  EXPECT_EQ(code, 0) << text;
  EXPECT_THAT(text, HasSubstr("6 of 6 devices heard"));
  EXPECT_THAT(text, testing::ContainsRegex("nothing found in (60|59)\\.[0-9] s"));
  EXPECT_THAT(text, HasSubstr("could not have been seen here:\n"));
  EXPECT_THAT(text, HasSubstr(": a file has no port: port-lost\n"));
}

TEST_F(Diagnosing, JsonHasTheFindingsAndWhatCouldNotHaveBeenSeen) {
  const auto outcome = read_recording(
      recorded("[[fault]]\ndevice = \"emlog\"\nfault = \"hang\"\nstart_s = 20\nfor_s = 15\n"));
  const auto json = nlohmann::json::parse(told(outcome, {.report = "", .json = true}).second);
  EXPECT_NEAR(json["duration_s"].get<double>(), 60, 0.5);
  EXPECT_EQ(json["devices"].size(), 6u);
  EXPECT_EQ(json["findings"][0]["device"], "emlog");
  EXPECT_EQ(json["findings"][0]["cause"], "silent");
  for (const auto& one : json["unseen"]) EXPECT_FALSE(one["causes"].empty()) << one;
}

TEST_F(Diagnosing, TheReportHasAPlotOfTheDeviceForEachFinding) {
  const auto outcome = read_recording(
      recorded("[[fault]]\ndevice = \"emlog\"\nfault = \"hang\"\nstart_s = 20\nfor_s = 15\n"));
  told(outcome, {.report = folder_ / "out", .json = false});
  std::ifstream in(folder_ / "out" / "index.html");
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  EXPECT_THAT(page, HasSubstr("emlog: <span class=bad>silent</span> from "));
  EXPECT_THAT(page, HasSubstr("emlog: speed through the water"));
  EXPECT_THAT(page, HasSubstr("<figure class=plot"));
  EXPECT_THAT(page, HasSubstr("could not have been seen here"));
}

/// Three seconds of sentences; in one of them a digit is another.
TEST_F(Diagnosing, ACaptureOfOneLinkSaysThatItsFramesAreDamaged) {
  std::ifstream in(DRYDOCK_SOURCE_DIR "/fixtures/nmea0183/golden.nmea", std::ios::binary);
  std::string sentences{std::istreambuf_iterator<char>(in), {}};
  const auto healthy = folder_ / "healthy.nmea", damaged = folder_ / "damaged.nmea";
  std::ofstream(healthy, std::ios::binary) << sentences;
  char& digit = sentences.at(sentences.find(',', sentences.size() / 2) - 1);
  digit = digit == '1' ? '2' : '1';
  std::ofstream(damaged, std::ios::binary) << sentences;
  const auto outcome = read_capture(damaged, 4800);
  ASSERT_THAT(outcome.findings, Not(IsEmpty())) << told(outcome).second;
  EXPECT_THAT(outcome.findings, Each(Field(&diagnosis::FindingAccount::cause, "damaged")));
  EXPECT_THAT(told(outcome).second, HasSubstr("a capture of bytes has no times"));
  EXPECT_THAT(read_capture(healthy, 4800).findings, IsEmpty());
}

/// Its pauses are not in the file: nothing that is found may follow from them.
TEST_F(Diagnosing, ACaptureOfBytesHasNoFindingsAboutTime) {
  const auto outcome = read_capture(DRYDOCK_SOURCE_DIR "/fixtures/nmea0183/golden.nmea", 115200);
  ASSERT_FALSE(outcome.circumstances.has_times);
  const auto why =
      std::ranges::find(outcome.unseen, "the capture has no times of arrival", &Unseen::why);
  ASSERT_NE(why, outcome.unseen.end());
  EXPECT_THAT(why->causes, testing::Contains(diagnosis::Cause::silent));
}

/// docs/estimators/dead-reckoning.md has its source. The wire says that tilts were used, but
/// velocity down and depth rate differ by speed times sin(pitch): the data are not levelled.
TEST_F(Diagnosing, TheDiveOfAnAuvUsesItsTiltsWronglyAndHasNoOtherFault) {
  const char* named = std::getenv("DRYDOCK_CORPORA");
  const fs::path dive = fs::path{named ? named : DRYDOCK_SOURCE_DIR "/../shared/corpora"} /
                        "dvl/pd0/raw/remus_20141219_a.adc";
  if (!fs::exists(dive)) GTEST_SKIP() << "no dive at " << dive;
  const auto outcome = read_capture(dive, 0);
  ASSERT_THAT(outcome.findings, Not(IsEmpty()));
  EXPECT_FALSE(outcome.findings[0].until_s);
  double first_s = outcome.circumstances.duration_s;
  for (const auto& finding : outcome.findings) {
    EXPECT_EQ(finding.cause, "mounting");
    ASSERT_EQ(finding.evidence.size(), 1u);
    EXPECT_EQ(finding.evidence[0].quantity, "share of the tilts used wrongly");
    EXPECT_LT(finding.evidence[0].value, -50);  // -100, less what the fit's prior holds back
    first_s = std::min(first_s, finding.found_s);
  }
  EXPECT_LT(first_s, 180);  // two minutes of windows, and gaps
  for (const Unseen& one : outcome.unseen)
    EXPECT_THAT(one.causes, Not(testing::Contains(diagnosis::Cause::mounting)));
}

/// A river transect: the ADCP pings as fast as its range lets it, so its rate changes. By its own
/// clock no ensemble comes twice.
TEST_F(Diagnosing, ACaptureWithoutTimesWhoseRateChangesHasNoDuplicates) {
  const char* named = std::getenv("DRYDOCK_CORPORA");
  const fs::path transect = fs::path{named ? named : DRYDOCK_SOURCE_DIR "/../shared/corpora"} /
                            "dvl/pd0/raw/tanana_transects_08_10_10_0_002_10-08-10_142214.PD0";
  if (!fs::exists(transect)) GTEST_SKIP() << "no transect at " << transect;
  for (const auto& finding : read_capture(transect, 0).findings)
    EXPECT_NE(finding.cause, "duplicate");
}

TEST_F(Diagnosing, ALinkThatCannotBeOpenedIsAnError) {
  EXPECT_THROW(listen_to_link("pty:nobody-plays-this", 1), std::runtime_error);
  EXPECT_THROW(listen_to_link("/no/such/file", 1), std::runtime_error);
}

/// 20 s of an IMU at 10 Hz (the frames of fixtures/aceinna), four years, and 20 s again.
TEST_F(Diagnosing, ATraceThatStandsStillForYearsIsReadAtOnce) {
  const auto trace = folder_ / "trace.log";
  std::ofstream out(trace);
  for (const double begin : {1.0e9, 1.126e9})
    for (int i = 0; i < 200; ++i)
      for (const char* frame :
           {"0CF02980#C7AA7E5C826B4406", "08F02D80#3179557D0A7DC0FF", "0CF02A80#C981EB7C79790006"})
        out << std::fixed << '(' << begin + 0.1 * i << ") can0 " << frame << '\n';
  out.close();
  const auto outcome = read_capture(trace, 0);
  ASSERT_EQ(outcome.devices.size(), 1u);
  EXPECT_NEAR(outcome.circumstances.duration_s, 1.26e8 + 19.9, 1);
  const auto silent =
      std::ranges::find(outcome.findings, "silent", &diagnosis::FindingAccount::cause);
  ASSERT_NE(silent, outcome.findings.end());
  // The same sample for 20 s is a finding too, and a better word keeps the beginning.
  EXPECT_LE(silent->since_s, 20.1);
  EXPECT_GT(silent->found_s, 19.9);
}

TEST_F(Diagnosing, ACaptureWithoutASensorIsNoSuccess) {
  const auto noise = folder_ / "noise.bin";
  std::ofstream(noise, std::ios::binary) << std::string(5000, '\x55');
  const auto [code, text] = told(read_capture(noise, 115200));
  EXPECT_EQ(code, 1);
  EXPECT_THAT(text, HasSubstr("no sensor was recognised"));
  EXPECT_THAT(text, Not(HasSubstr("nothing found")));
}

diagnosis::FindingAccount finding(const char* device, bool severe, double confidence) {
  diagnosis::FindingAccount account;
  account.device = device;
  account.severe = severe;
  account.confidence = confidence;
  return account;
}

TEST(WorstFirst, IsWhatLastsAndMakesValuesUselessThenWhatIsSure) {
  std::vector<diagnosis::FindingAccount> all{
      finding("mild", false, 0.99), finding("over", true, 0.9), finding("unsure", true, 0.5),
      finding("worst", true, 0.9)};
  all[1].until_s = 10;
  put_worst_first(all);
  std::vector<std::string> order;
  for (const auto& one : all) order.push_back(one.device);
  EXPECT_THAT(order, testing::ElementsAre("worst", "unsure", "over", "mild"));
}

}  // namespace recording_test
}  // namespace drydock::diagnose
