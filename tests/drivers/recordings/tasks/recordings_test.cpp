#include "drivers/recordings/tasks/recordings.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "drivers/recordings/tasks/fixture.hpp"
#include "drivers/text/utc.hpp"
#include "tests/drivers/decode/captured.hpp"
#include "tests/drivers/recordings/sample_dive/sample_dive.hpp"

namespace drydock::recordings {
namespace recordings_test {

using record::test::read_all;
using testing::HasSubstr;

constexpr auto to_the_end = [](double) { return true; };

class RecordingCommand : public testing::Test {
 protected:
  record::test::TestFolder folder_;
  std::string dive_ = folder_ / "dive.mcap";
  record::test::SampleCounts counts_ = record::test::write_sample_dive(dive_);
  decode::MemoryFile err_;
};

TEST_F(RecordingCommand, ExportSaysInALineWhatItWroteOrWhyNot) {
  ExportOptions options;
  options.recording = dive_;
  options.target.path = folder_ / "dive.log";
  EXPECT_EQ(export_recording(options, to_the_end, err_.file()), 0);
  EXPECT_EQ(err_.text(), options.target.path + ": " + std::to_string(counts_.frames) + " frames\n");
  EXPECT_EQ(export_recording(options, to_the_end, err_.file()), 1);
  EXPECT_THAT(err_.text(), HasSubstr("export: " + options.target.path + ": File exists"));
  options.part.only = {"dvl"};
  options.target.overwrite = true;
  EXPECT_EQ(export_recording(options, to_the_end, err_.file()), 1);
  EXPECT_THAT(err_.text(), HasSubstr("that candump could hold"));
}

TEST_F(RecordingCommand, RecoverSaysWhatWasWrongAndWhatIsSaved) {
  const std::string whole = read_all(dive_);
  std::ofstream(folder_ / "cut.mcap", std::ios::binary) << whole.substr(0, whole.size() / 2);
  EXPECT_EQ(recover({folder_ / "cut.mcap", folder_ / "saved.mcap"}, to_the_end, err_.file()), 0);
  EXPECT_THAT(err_.text(), HasSubstr("the file is cut here"));
  EXPECT_THAT(err_.text(), testing::ContainsRegex("saved.mcap: [0-9]+ messages of [0-9.]+ s and 3 "
                                                  "attachments saved"));
  EXPECT_EQ(recover({folder_ / "cut.mcap", folder_ / "saved.mcap"}, to_the_end, err_.file()), 1);
  EXPECT_THAT(err_.text(), HasSubstr("saved.mcap: File exists; --overwrite replaces it"));
  EXPECT_EQ(recover({"/nowhere.mcap", ""}, to_the_end, err_.file()), 1);
  EXPECT_THAT(err_.text(), HasSubstr("recover: /nowhere.mcap: No such file or directory"));
}

TEST_F(RecordingCommand, RecoverThatIsEndedKeepsACompleteRecordingOfWhatItRead) {
  int left = 50;
  const std::string saved = folder_ / "saved.mcap";
  EXPECT_EQ(recover(
                {dive_, saved}, [&](double) { return --left > 0; }, err_.file()),
            0);
  EXPECT_THAT(err_.text(), HasSubstr("not read to its end"));
  EXPECT_THAT(err_.text(), HasSubstr("attachments saved, ended by Ctrl-C"));
  EXPECT_EQ(recover({saved, folder_ / "again.mcap"}, to_the_end, err_.file()), 0);
  EXPECT_THAT(err_.text(), HasSubstr("saved.mcap: whole, nothing to mend"));
}

TEST_F(RecordingCommand, AFixtureHoldsWhatBecameOfTheBytes) {
  CutOptions options;
  options.recording = dive_;
  options.fixture = "lost-lock";
  options.fixtures_folder = folder_ / "dives";
  EXPECT_EQ(cut(options, to_the_end, err_.file()), 0) << err_.text();
  const std::string reference = read_all(folder_ / "dives/lost-lock/expected.jsonl");
  EXPECT_THAT(reference, HasSubstr(R"({"device":"gps","type":"gnss_fix")"));
  EXPECT_THAT(reference, HasSubstr(R"({"device":"dvl","type":"bottom_velocity")"));
  EXPECT_THAT(reference, HasSubstr(R"({"device":"depth","type":"depth")"));
  EXPECT_THAT(read_all(folder_ / "dives/lost-lock/NOTES.md"), HasSubstr("# lost-lock"));
  decode::MemoryFile again;
  EXPECT_TRUE(write_reference(folder_ / "dives/lost-lock/dive.mcap", again.file()));
  EXPECT_EQ(again.text(), reference);
}

TEST_F(RecordingCommand, BisectKeepsTheSmallestSliceForWhichACommandFails) {
  BisectOptions options;
  options.recording = dive_;
  options.output = folder_ / "smallest.mcap";
  options.command = "test $(wc -c < {}) -lt 3500";
  EXPECT_EQ(bisect(options, to_the_end, err_.file()), 0) << err_.text();
  EXPECT_THAT(err_.text(), HasSubstr("still fails with"));
  EXPECT_GE(std::filesystem::file_size(options.output), 3500U);
  EXPECT_LT(std::filesystem::file_size(options.output), std::filesystem::file_size(dive_));
  EXPECT_FALSE(std::filesystem::exists(options.output + ".trial.mcap"));
  options.output = folder_ / "other.mcap";
  options.command = "true {}";
  EXPECT_EQ(bisect(options, to_the_end, err_.file()), 1);
  EXPECT_THAT(err_.text(), HasSubstr("bisect: the command succeeds on the whole recording"));
  options.command = "/no/such/program {} 2>/dev/null";
  EXPECT_EQ(bisect(options, to_the_end, err_.file()), 1);
  EXPECT_THAT(err_.text(), HasSubstr("cannot be run (exit code 127)"));
}

TEST(ParseUtc, TakesATimeOfAllItsDigits) {
  EXPECT_EQ(text::parse_utc("2020-01-01T00:00:00Z"),
            measurement::stamp_from_ns(1'577'836'800'000'000'000));
  EXPECT_EQ(text::parse_utc("2020-01-01T00:00:00.25Z"),
            measurement::stamp_from_ns(1'577'836'800'250'000'000));
  for (const auto* none :
       {"", "2020-01-01", "2020-13-01T00:00:00Z", "2020-01-01T24:00:00Z", "2020-01-01T00:00:00",
        "2020-01-01T00:00:00.Z", "2020-01-01T00:00:00,5Z"})
    EXPECT_FALSE(text::parse_utc(none)) << none;
}

}  // namespace recordings_test
}  // namespace drydock::recordings
