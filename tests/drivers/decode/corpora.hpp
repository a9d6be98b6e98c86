#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/drivers/decode/captured.hpp"

/// Compares `decode` with counts from simpler means: a scanner of a few lines that knows only
/// checksums, or the output of another decoder.
namespace drydock::decode::corpora {

namespace fs = std::filesystem;
using Counts = std::map<std::string, int>;
using nlohmann::json;

class Corpora : public testing::Test {
 protected:
  void SetUp() override {
    const char* named = std::getenv("DRYDOCK_CORPORA");
    root_ = named ? named : DRYDOCK_SOURCE_DIR "/../shared/corpora";
    if (!fs::exists(root_)) GTEST_SKIP() << "no captures in " << root_;
  }
  std::vector<fs::path> files(const char* folder, const char* extension) const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(root_ / folder))
      if (entry.path().extension() == extension) found.push_back(entry.path());
    return found;
  }
  fs::path root_;
};

inline Counts decoded_counts(const std::string& protocol, const fs::path& file) {
  Counts counts;
  for (const json& line : run_decode({protocol, file.string(), true, true}).lines())
    counts[line["type"]] = line["count"];
  return counts;
}

inline Counts decoded_lines(const std::string& protocol, const fs::path& file) {
  Counts counts;
  for (const json& line : run_decode({protocol, file.string(), false, true}).lines())
    ++counts[line["type"]];
  return counts;
}

}  // namespace drydock::decode::corpora
