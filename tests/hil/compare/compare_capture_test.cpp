#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "hil/compare/compare.hpp"

namespace drydock::compare {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr auto from_the_bay =
    "dead-reckoning:reckoning.latitude_deg=41.554:reckoning.longitude_deg=-70.705";

CompareOptions of_capture(const std::string& file, std::vector<std::string> estimators) {
  CompareOptions options;
  options.source.capture = file;
  options.source.protocol = "pd0";
  options.estimators = std::move(estimators);
  return options;
}

std::string golden() { return DRYDOCK_SOURCE_DIR "/fixtures/pd0/golden.pd0"; }

std::string refusal(const CompareOptions& options) {
  try {
    compare_on_capture(options);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

TEST(ComparingOnACapture, SaysWhatIsMissing) {
  auto options = of_capture(golden(), {from_the_bay});
  options.source.protocol.clear();
  EXPECT_THAT(refusal(options), HasSubstr("--protocol says what its sensor speaks"));
  EXPECT_THAT(refusal(of_capture(DRYDOCK_SOURCE_DIR "/README.md", {from_the_bay})),
              HasSubstr("made no measurement of it"));
  EXPECT_THAT(refusal(of_capture(golden(), {"dead-reckoning"})),
              HasSubstr("latitude_deg and longitude_deg"));
  options = of_capture(golden(), {from_the_bay});
  options.part.only = {"gnss"};
  EXPECT_THAT(refusal(options), HasSubstr("a capture has one sensor, \"dvl\""));
}

TEST(ComparingOnACapture, TakesTheSensorFromARigFile) {
  const auto file = fs::temp_directory_path() / fmt::format("capture-rig-{}.toml", ::getpid());
  std::ofstream(file) << "[rig]\nname = \"boat\"\n"
                         "[[device]]\nname = \"gps\"\nkind = \"gnss\"\nprotocol = \"ubx\"\n"
                         "link = \"pty:gps\"\n"
                         "[[device]]\nname = \"head\"\nkind = \"dvl\"\nprotocol = \"pd0\"\n"
                         "link = \"pty:head\"\n";
  auto options = of_capture(golden(), {from_the_bay});
  options.rig = file.string();
  const auto comparison = compare_on_capture(options);
  EXPECT_GT(comparison.entries.at(0).summary.estimates, 0u);
  options.source.protocol.clear();
  EXPECT_THAT(refusal(options), HasSubstr("--only names it, one of gps (ubx), head (pd0)"));
  options.part.only = {"head"};
  EXPECT_EQ(compare_on_capture(options).measurements, comparison.measurements);
  fs::remove(file);
}

/// nav.csv of the dive: 1934 ensembles, one in 2.03 s, and a step of 4722.07 s. One ensemble has no
/// bottom track.
TEST(ComparingOnACapture, OfARealDiveShowsThePauseAndTheCostOfEachEstimator) {
  const char* corpora = std::getenv("DRYDOCK_CORPORA");
  const fs::path dive =
      fs::path(corpora != nullptr ? corpora : DRYDOCK_SOURCE_DIR "/../shared/corpora") /
      "dvl/pd0/raw/remus_20141219_a.adc";
  if (!fs::exists(dive)) GTEST_SKIP() << "no dive in " << dive;
  const auto comparison = compare_on_capture(
      of_capture(dive.string(), {from_the_bay, std::string(from_the_bay) + ":reckoning.gap_s=3"}));
  EXPECT_EQ(comparison.measurements, 1934u);
  EXPECT_FALSE(comparison.truth);
  for (const auto& entry : comparison.entries) {
    EXPECT_EQ(entry.used, 1933u);
    EXPECT_NEAR(entry.gaps.longest_s, 4722.07, 4.1);
    EXPECT_GT(entry.cost_us(), 0);
  }
}

TEST(ComparingOnACapture, InTwoFilesThroughARigIsThatOfTheWholeOne) {
  const char* corpora = std::getenv("DRYDOCK_CORPORA");
  const fs::path dive =
      fs::path(corpora != nullptr ? corpora : DRYDOCK_SOURCE_DIR "/../shared/corpora") /
      "dvl/pd0/raw/remus_20141219_a.adc";
  if (!fs::exists(dive)) GTEST_SKIP() << "no dive in " << dive;
  const auto folder = fs::temp_directory_path() / fmt::format("two-files-{}", ::getpid());
  fs::create_directories(folder);
  std::ifstream in(dive, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  std::ofstream(folder / "a.adc", std::ios::binary) << bytes.substr(0, 300'001);
  std::ofstream(folder / "b.adc", std::ios::binary) << bytes.substr(300'001);
  std::ofstream(folder / "rig.toml") << "[rig]\nname = \"auv\"\n[[device]]\nname = \"dvl\"\nkind = "
                                        "\"dvl\"\nprotocol = \"pd0\"\nlink = \"pty:dvl\"\n";
  auto options = of_capture("", {from_the_bay});
  options.source.protocol.clear();
  options.rig = (folder / "rig.toml").string();
  options.captures = {{(folder / "b.adc").string(), "dvl"}, {(folder / "a.adc").string(), "dvl"}};
  const auto joined = compare_through_rig(options);
  const auto whole = compare_on_capture(of_capture(dive.string(), {from_the_bay}));
  EXPECT_EQ(joined.measurements, whole.measurements);
  EXPECT_EQ(joined.entries.at(0).used, whole.entries.at(0).used);
  EXPECT_EQ(joined.entries.at(0).summary.estimates, whole.entries.at(0).summary.estimates);
  EXPECT_EQ(joined.entries.at(0).gaps.longest_s, whole.entries.at(0).gaps.longest_s);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace drydock::compare
