#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tests/conformance/score.hpp"

/// The contract of every corpus: discover its captures by pattern, decode each through the
/// product's own way, compare with what stands beside it, into one score.
namespace drydock::conformance {

namespace fs = std::filesystem;

/// A capture and the file with what another program read in it. Without `expected` a comparer can
/// only count; without `capture` the expected values are an orphan, which is an error.
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

/// Reads what cannot be read as a reference: file, line, reason.
struct Unreadable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Files of a folder, sorted; none when there is no such folder.
std::vector<fs::path> files_of(const fs::path& folder, std::string_view extension = {});

/// Each capture with the file that `expected_of` names, where there is one, and each of `expected`
/// that no capture claimed.
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

/// Captures that hold their own expected values: vectors, one a line.
std::vector<Case> vectors(const std::vector<fs::path>& files);

using Progress = std::function<void(const Corpus&, const fs::path& capture)>;

/// One corpus below `root`; `progress` is called before each capture.
Score score(const Corpus& corpus, const fs::path& root, const Progress& progress = {});

struct Result {
  std::string name;
  Score score;
};

/// Every corpus that `root` has something of.
std::vector<Result> score_all(const fs::path& root, const Progress& progress = {});

/// Whether nothing is wrong.
bool clean(const std::vector<Result>& results);

}  // namespace drydock::conformance
