#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tests/conformance/score.hpp"

/// The contract of every corpus: discover its captures by pattern, decode each with drydock's own
/// code, compare with the reference beside it, and add everything to one score.
namespace drydock::conformance {

namespace fs = std::filesystem;

/// A capture, and the file with the values that another program read in it. Without `expected` a
/// comparer can only count. Without `capture` the expected values are an orphan, which is an error.
struct Case {
  fs::path capture, expected;
};

struct Corpus {
  std::string_view name;
  std::string_view folder;  ///< below the root
  std::vector<Case> (*discover)(const fs::path& folder);
  void (*compare)(const Case&, Score&);
};

std::span<const Corpus> corpora();

/// A reference cannot be read: file, line, reason.
struct Unreadable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Files of a folder, sorted. Empty if there is no such folder.
std::vector<fs::path> files_of(const fs::path& folder, std::string_view extension = {});

/// Each capture with the file that `expected_of` names, if there is one, and each file of
/// `expected` that belongs to no capture.
template <class ExpectedOf>
std::vector<Case> paired(const std::vector<fs::path>& captures, std::vector<fs::path> expected,
                         ExpectedOf&& expected_of) {
  std::vector<Case> cases;
  for (const fs::path& capture : captures) {
    const fs::path beside = expected_of(capture);
    cases.push_back({capture, fs::exists(beside) ? beside : fs::path{}});
    std::erase(expected, beside);
  }
  for (const fs::path& orphan : expected) cases.push_back({{}, orphan});
  return cases;
}

/// Captures that contain their own expected values: vectors, one on each line.
std::vector<Case> vectors(const std::vector<fs::path>& files);

using Progress = std::function<void(const Corpus&, const fs::path& capture)>;

/// Scores one corpus below `root`. It calls `progress` before each capture.
Score score(const Corpus& corpus, const fs::path& root, const Progress& progress = {});

struct Result {
  std::string name;
  Score score;
};

/// Scores every corpus with a file below `root`.
std::vector<Result> score_all(const fs::path& root, const Progress& progress = {});

/// True if nothing is wrong.
bool clean(const std::vector<Result>& results);

}  // namespace drydock::conformance
