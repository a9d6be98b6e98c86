#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/conformance/report.hpp"

namespace drydock::conformance {
namespace {

TEST(Conformance, NothingIsWrongInTheCapturesOfOthers) {
  const char* named = std::getenv("DRYDOCK_CORPORA");
  const fs::path root = named ? named : DRYDOCK_SOURCE_DIR "/../shared/corpora";
  if (!fs::exists(root)) GTEST_SKIP() << "no captures in " << root;
  const auto results = score_all(root);
  EXPECT_FALSE(results.empty());
  if (clean(results)) return;
  print_table(results, true, stdout);
  FAIL() << "see the table";
}

}  // namespace
}  // namespace drydock::conformance
