#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

/// The result of reading a corpus: counts, errors relative to the wire's resolution, every
/// difference.
namespace drydock::conformance {

using nlohmann::json;

/// The permitted error: half a step of the wire's field, and the rounding of the reference itself,
/// relative to its value.
struct Step {
  double resolution = 1;
  double relative = 0;
};
constexpr double float32_rounding = 1.2e-7;

/// A known defect or convention of a reference. It is a condition on the data, never on a file.
struct Rule {
  std::string_view name, reason;
};

struct Difference {
  std::string file;
  std::size_t message = 0;  ///< from 1, as in the reference
  std::string field, ours, theirs;
};

struct FieldError {
  double largest = 0;
  double resolution = 1;
};

/// Compares one message of a capture with the values of another program. null means "no value", and
/// only null equals it.
class Comparison {
 public:
  Comparison(std::string file, std::size_t message) : file_(std::move(file)), message_(message) {}

  void number(std::string_view field, const json& ours, const json& theirs, Step step);
  void same(std::string_view field, const json& ours, const json& theirs);
  void by_rule(const Rule& rule) { rules_.push_back(rule); }
  bool agrees() const { return differences_.empty(); }

 private:
  friend class Score;
  void differ(std::string_view field, const json& ours, const json& theirs);

  std::string file_;
  std::size_t message_;
  std::map<std::string, FieldError, std::less<>> errors_;
  std::vector<Difference> differences_;
  std::vector<Rule> rules_;
};

/// The score of one corpus. expected = matched + missed + wrong, without the messages that nobody
/// expected; these count as wrong too.
class Score {
 public:
  struct Counts {
    std::uint64_t captures = 0, expected = 0, matched = 0, missed = 0, wrong = 0;
    std::uint64_t by_value = 0;  ///< part of matched: compared field by field, not only counted
    std::uint64_t by_rule = 0;   ///< part of matched: a rule explains the difference
  };

  void add(const Comparison& comparison);  ///< one expected message that was decoded
  void matched(std::uint64_t count);       ///< they were decoded, but the reference has no values
  void missed(const std::string& file, std::size_t message, std::string_view theirs);
  void unexpected(const std::string& file, std::size_t message, std::string_view ours);
  void excused(const Rule& rule);  ///< expected, but impossible for a reason in the reference

  void capture() { ++counts_.captures; }
  void note(std::string text) { notes_.push_back(std::move(text)); }
  void error(std::string text) { errors_.push_back(std::move(text)); }

  bool clean() const { return counts_.missed == 0 && counts_.wrong == 0 && errors_.empty(); }
  const Counts& counts() const { return counts_; }
  const std::map<std::string, FieldError, std::less<>>& fields() const { return fields_; }
  const std::vector<Difference>& differences() const { return differences_; }
  const std::vector<std::string>& notes() const { return notes_; }
  const std::vector<std::string>& errors() const { return errors_; }

  struct RuleUse {
    std::string reason;
    std::uint64_t messages = 0;
  };
  const std::map<std::string, RuleUse>& rules() const { return rules_; }

 private:
  void use(const Rule& rule);

  Counts counts_;
  std::map<std::string, FieldError, std::less<>> fields_;
  std::map<std::string, RuleUse> rules_;
  std::vector<Difference> differences_;
  std::vector<std::string> notes_, errors_;
};

}  // namespace drydock::conformance
