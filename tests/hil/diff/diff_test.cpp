#include "hil/diff/diff.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "hil/diff/side.hpp"

/// `drydock diff` of recordings that are in the tree.
namespace diff_test {

using drydock::diff::diff;
using drydock::diff::DiffOptions;
using testing::HasSubstr;

const std::string dives = DRYDOCK_SOURCE_DIR "/fixtures/dives/";
const std::string bottom = dives + "dvl-finds-the-bottom/dive.mcap";
const std::string drops = dives + "log-drops-out/dive.mcap";

struct Ran {
  int exit_code;
  std::string out, err;
};

std::string text_of(std::FILE* file) {
  std::string text(static_cast<std::size_t>(std::ftell(file)), '\0');
  std::rewind(file);
  text.resize(std::fread(text.data(), 1, text.size(), file));
  return text;
}

Ran run(const DiffOptions& options) {
  const auto file = [] {
    return std::unique_ptr<std::FILE, int (*)(std::FILE*)>(std::tmpfile(), std::fclose);
  };
  const auto out = file(), err = file();
  const int code = diff(options, out.get(), err.get());
  return {code, text_of(out.get()), text_of(err.get())};
}

class Diff : public testing::Test {
 protected:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("drydock-diff-" + std::to_string(::getpid()));
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
};

TEST_F(Diff, OfARecordingAndItselfFindsNothing) {
  const auto ran = run({.a = bottom, .b = bottom, .json = true});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  const auto json = nlohmann::json::parse(ran.out);
  EXPECT_GT(json["compared"], 20);
  EXPECT_EQ(json["differences"], nlohmann::json::array());
}

TEST_F(Diff, OfTwoRecordingsSaysWhatDiffersAndDrawsBothInOnePlot) {
  const auto ran = run({.a = bottom, .b = drops, .report = folder_.string()});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("duration_s"));
  EXPECT_THAT(ran.err, HasSubstr("index.html"));
  std::ifstream in(folder_ / "index.html");
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  EXPECT_THAT(page, HasSubstr("duration_s"));
  EXPECT_THAT(page, HasSubstr("Both in one plot"));
}

TEST_F(Diff, TakesTheSummaryOfARunForTheRecordingOfIt) {
  const auto side = drydock::diff::read_side(bottom);
  const auto summary = folder_ / "summary.json";
  std::ofstream(summary) << side.summary;
  const auto ran = run({.a = summary.string(), .b = bottom});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("\n0 differences; "));
}

TEST_F(Diff, AFileThatIsNeitherIsOneAndIsNamed) {
  const auto words = folder_ / "words.txt";
  std::ofstream(words) << "no summary";
  const auto ran = run({.a = words.string(), .b = bottom});
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_THAT(ran.err, HasSubstr("words.txt: neither a recording (MCAP) nor the summary of a run"));
  EXPECT_EQ(run({.a = bottom, .b = (folder_ / "absent.mcap").string()}).exit_code, 1);
}

}  // namespace diff_test
