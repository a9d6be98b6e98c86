#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "tests/conformance/corpus.hpp"

namespace drydock::conformance {

/// A small folder of corpora that a test makes, with one error in it.
class Scoreboard : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "drydock_conformance_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    root_ = name;
  }
  void TearDown() override { fs::remove_all(root_); }

  void write(const std::string& file, const std::string& text) {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  /// The only corpus of the folder.
  Score only() {
    auto results = score_all(root_);
    EXPECT_EQ(results.size(), 1u);
    return results.empty() ? Score{} : std::move(results.front().score);
  }

  fs::path root_;
};

}  // namespace drydock::conformance
