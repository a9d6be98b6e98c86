#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drydock::wire::described {

inline constexpr std::size_t most_groups = 32;

/// A regular expression with named groups, in the syntax of RE2: a match takes time linear in the
/// line and memory that is bounded. Where the next character of a line always tells where the
/// pattern goes on, a match allocates nothing; else three times for every four groups.
class LinePattern {
 public:
  explicit LinePattern(const std::string& pattern);
  ~LinePattern();

  /// Why it cannot be used, in words; empty: it can.
  const std::string& error() const { return error_; }
  /// In their order in the pattern.
  const std::vector<std::string>& groups() const { return groups_; }

  /// True if the pattern is the whole line. `found` has a place for each group; a group that took
  /// no part is empty.
  bool match(std::string_view line, std::span<std::string_view> found) const;

 private:
  struct Part;  ///< the whole pattern with some of its groups
  void compile(const std::string& pattern);

  std::string error_;
  std::vector<std::string> groups_;
  std::vector<Part> parts_;
};

/// What an emulated device writes: text, and behind it the value of a field.
struct WrittenPiece {
  std::string text;
  int field = -1;  ///< of the message; -1: none
};

/// A message that is a line by a pattern.
struct PatternLine {
  explicit PatternLine(const std::string& text) : pattern(text) {}

  LinePattern pattern;
  std::vector<WrittenPiece> written;
};

}  // namespace drydock::wire::described
