#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "hil/report/table.hpp"
#include "hil/study/run/run_study.hpp"

namespace drydock::study {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The mean of standard normal draws, one per run.
study::Result mean_of_normals(const study::Options& options, study::Progress& progress) {
  study::Result result;
  double sum = 0;
  result.runs = study::campaign(
      "normals", options, progress,
      [&](std::size_t k) { return study::stream_of(options.seed, k, "x").normal(); },
      [&](std::size_t, double x) { sum += x; });
  const double mean = sum / static_cast<double>(result.runs);
  result.json["mean"] = mean;
  result.tables = {{"Means", {"σ", "paper", "ours"}, {{"1", "0", std::to_string(mean)}}, "n < m"}};
  result.figures = {{"Line & curve", "time [s]", "m", {{"line", {0, 1}, {0, mean}}}}};
  return result;
}

constexpr study::Study normals{"normals", "Normal draws", mean_of_normals};

/// A study that presses Ctrl-C in its third run.
study::Result interrupted_study(const study::Options& options, study::Progress& progress) {
  study::Result result;
  result.runs = study::campaign(
      "normals", options, progress,
      [](std::size_t k) {
        if (k == 2) std::raise(SIGINT);
        return k;
      },
      [](std::size_t, std::size_t) {});
  return result;
}

std::string text_of(std::FILE* file) {
  std::string text;
  std::rewind(file);
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
  return text;
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

class StudyCommand : public testing::Test {
 protected:
  void TearDown() override {
    std::fclose(out_);
    std::fclose(errors_);
    std::filesystem::remove_all(folder_);
  }

  std::filesystem::path folder_ = [] {
    auto name = (std::filesystem::temp_directory_path() / "drydock-study-XXXXXX").string();
    return std::filesystem::path(mkdtemp(name.data()));
  }();
  std::FILE* out_ = std::tmpfile();
  std::FILE* errors_ = std::tmpfile();
};

TEST_F(StudyCommand, PrintsTheTableAndWritesJsonAndReport) {
  StudyOptions options;
  options.campaign = {30, 4, 2};
  options.json = folder_ / "deep" / "out.json";
  options.report = folder_ / "report";
  EXPECT_EQ(run_study(normals, options, out_, errors_), 0);
  EXPECT_THAT(text_of(out_), HasSubstr("Means\nσ  paper"));
  // Not a terminal: one line and no bar.
  EXPECT_THAT(text_of(errors_), testing::MatchesRegex("normals: 30 of 30 runs, seed 4, .* s\n"));
  const auto json = nlohmann::json::parse(text_of(folder_ / "deep" / "out.json"));
  EXPECT_EQ(json["study"]["runs_done"], 30);
  EXPECT_EQ(json["study"]["seed"], 4);
  EXPECT_TRUE(json["mean"].is_number());
  const auto page = text_of(folder_ / "report" / "index.html");
  EXPECT_THAT(page, HasSubstr("n &lt; m"));
  EXPECT_THAT(page, HasSubstr("<figure class=plot"));
  for (const char* elsewhere : {"src=", "<script src", "<link", "@import"})
    EXPECT_THAT(page, Not(HasSubstr(elsewhere)));
}

TEST_F(StudyCommand, FilesAreTheSameWithAnyNumberOfJobs) {
  StudyOptions options;
  const auto written = [&](unsigned jobs) {
    options.campaign = {30, 4, jobs};
    options.json = folder_ / "out.json";
    options.report = folder_;
    EXPECT_EQ(run_study(normals, options, out_, errors_), 0);
    return text_of(folder_ / "out.json") + text_of(folder_ / "index.html");
  };
  const auto alone = written(1);
  EXPECT_EQ(written(7), alone);
}

TEST_F(StudyCommand, CtrlCEndsWithTheRunsDone) {
  StudyOptions options;
  options.campaign = {1000, 1, 1};
  EXPECT_EQ(run_study({"stopped", "", interrupted_study}, options, out_, errors_), 1);
  EXPECT_THAT(text_of(errors_), HasSubstr("stopped: 3 of 1000 runs"));
  EXPECT_THAT(text_of(errors_), HasSubstr("ended by Ctrl-C"));
}

TEST_F(StudyCommand, AFileThatCannotBeWrittenIsSaidBeforeTheWork) {
  StudyOptions options;
  options.json = "/proc/no/such.json";
  EXPECT_EQ(run_study(normals, options, out_, errors_), 1);
  EXPECT_EQ(text_of(errors_),
            "study: /proc/no/such.json: cannot be written: No such file or directory\n");
  EXPECT_EQ(text_of(out_), "");
}

TEST_F(StudyCommand, AnUnknownNameIsOneLineThatSaysWhatIsAllowed) {
  StudyOptions options;
  options.name = "levelling";
  EXPECT_EQ(run_study(options, out_, errors_), 2);
  EXPECT_EQ(text_of(errors_),
            "study: 'levelling' is not known (did you mean 'leveling'?), allowed: " +
                study_names() + "\n");
}

TEST_F(StudyCommand, CasesAreHandedToTheStudyThatHasThem) {
  const study::Study with_cases{"two", "",
                                [](const study::Options& options, study::Progress&) {
                                  study::Result result;
                                  result.runs = options.runs;
                                  result.tables = {{options.cases.at(0), {}, {}, ""}};
                                  return result;
                                },
                                nullptr,
                                [] {
                                  return std::vector<std::string_view>{"first", "second"};
                                }};
  StudyOptions options;
  options.campaign.cases = {"second"};
  EXPECT_EQ(run_study(with_cases, options, out_, errors_), 0);
  EXPECT_THAT(text_of(out_), HasSubstr("second"));
}

TEST_F(StudyCommand, AnUnknownCaseIsOneLineThatSaysWhatIsAllowed) {
  const study::Study with_cases{"two", "", mean_of_normals, nullptr, [] {
                                  return std::vector<std::string_view>{"first", "second"};
                                }};
  StudyOptions options;
  options.campaign.cases = {"first", "third"};
  EXPECT_EQ(run_study(with_cases, options, out_, errors_), 2);
  EXPECT_EQ(text_of(errors_), "study two: case 'third' is not known, allowed: first, second\n");
  EXPECT_EQ(text_of(out_), "");
}

TEST_F(StudyCommand, AStudyWithoutCasesSaysSo) {
  StudyOptions options;
  options.campaign.cases = {"first"};
  EXPECT_EQ(run_study(normals, options, out_, errors_), 2);
  EXPECT_EQ(text_of(errors_), "study normals: has no cases to choose from\n");
}

TEST(StudyTable, ColumnsStandBelowEachOtherWhateverTheAlphabet) {
  const report::Table table{"T", {"filter", "φ [°]"}, {{"a", "1.0000"}, {"bb", "-2"}}, ""};
  EXPECT_EQ(report::to_text(table), "T\nfilter   φ [°]\na       1.0000\nbb          -2\n");
}

}  // namespace
}  // namespace drydock::study
