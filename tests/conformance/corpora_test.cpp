#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "tests/conformance/report.hpp"

/// The scoreboard, a test for each of its rows.
namespace drydock::conformance {
namespace {

class Conformance : public testing::TestWithParam<Corpus> {};

TEST_P(Conformance, NothingIsWrongInTheCapturesOfOthers) {
  const char* named = std::getenv("DRYDOCK_CORPORA");
  const fs::path root = named ? named : DRYDOCK_SOURCE_DIR "/../shared/corpora";
  if (!fs::exists(root)) GTEST_SKIP() << "no captures in " << root;
  const Result result{std::string(GetParam().name), score(GetParam(), root)};
  if (result.score.counts().captures == 0 && result.score.errors().empty())
    GTEST_SKIP() << "no captures of " << result.name << " in " << root;
  if (result.score.clean()) return;
  print_table({result}, true, stdout);
  FAIL() << "see the table";
}

std::string test_name(const testing::TestParamInfo<Corpus>& corpus) {
  std::string name(corpus.param.name);
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Corpora, Conformance,
                         testing::ValuesIn(corpora().begin(), corpora().end()), test_name);

}  // namespace
}  // namespace drydock::conformance
