#include "drivers/wire/described/line_pattern.hpp"

#include <re2/re2.h>

#include <array>

namespace drydock::wire::described {
namespace {

/// RE2 reads up to four groups without allocating.
constexpr std::size_t groups_at_once = 4;
constexpr int most_instructions = 2000;
constexpr std::int64_t most_memory = 1 << 20;
constexpr std::string_view group_start = "(?P<";

RE2::Options options() {
  RE2::Options options;
  options.set_log_errors(false);
  options.set_encoding(RE2::Options::EncodingLatin1);  // a line has bytes, not code points
  options.set_never_capture(true);                     // of groups without a name
  options.set_max_mem(most_memory);
  return options;
}

/// The end of a character class that begins at `at`: its bracket, or the end of the pattern.
std::size_t end_of_class(std::string_view pattern, std::size_t at) {
  std::size_t i = at + 1;
  if (i < pattern.size() && pattern[i] == '^') ++i;
  if (i < pattern.size() && pattern[i] == ']') ++i;
  for (; i < pattern.size() && pattern[i] != ']'; ++i) {
    const auto name = pattern.substr(i).starts_with("[:") ? pattern.find(":]", i) : pattern.npos;
    if (name != pattern.npos) i = name + 1;
    if (pattern[i] == '\\') ++i;
  }
  return i;
}

/// Calls `group(from, end)` for the head of each named group, as `(?P<depth>`.
template <class F>
void for_each_group(std::string_view pattern, F&& group) {
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] == '\\')
      ++i;
    else if (pattern[i] == '[')
      i = end_of_class(pattern, i);
    else if (pattern.substr(i).starts_with(group_start)) {
      const auto end = pattern.find('>', i);
      if (end == pattern.npos) return;
      group(i, end + 1);
      i = end;
    }
  }
}

/// The pattern with the groups from `first` on, `groups_at_once` of them; the others lose their
/// names.
std::string with_some(std::string_view pattern, std::size_t first) {
  std::string result;
  std::size_t copied = 0, place = 0;
  for_each_group(pattern, [&](std::size_t from, std::size_t end) {
    const bool wanted = place >= first && place < first + groups_at_once;
    ++place;
    if (wanted) return;
    result.append(pattern.substr(copied, from - copied)).append("(?:");
    copied = end;
  });
  return result.append(pattern.substr(copied));
}

}  // namespace

struct LinePattern::Part {
  std::unique_ptr<RE2> expression;
  std::size_t groups = 0;
};

LinePattern::LinePattern(const std::string& pattern) {
  for_each_group(pattern, [&](std::size_t from, std::size_t end) {
    from += group_start.size();
    groups_.push_back(pattern.substr(from, end - 1 - from));
  });
  compile(pattern);
}

LinePattern::~LinePattern() = default;

void LinePattern::compile(const std::string& pattern) {
  const RE2 whole(pattern, options());
  const auto& names = whole.NamedCapturingGroups();
  if (!whole.ok())
    error_ = whole.error();
  else if (whole.ProgramSize() > most_instructions)
    error_ = "it is too large";
  else if (names.empty())
    error_ = "it has no named group, such as (?P<depth>[0-9.]+)";
  else if (groups_.size() > most_groups)
    error_ = "it has more than 32 groups";
  else if (names.size() != groups_.size())
    error_ = "two groups have one name, or a name stands behind \\Q";
  for (std::size_t first = 0; error_.empty() && first < groups_.size(); first += groups_at_once) {
    Part part;
    part.expression = std::make_unique<RE2>(with_some(pattern, first), options());
    part.groups = std::min(groups_at_once, groups_.size() - first);
    parts_.push_back(std::move(part));
  }
}

bool LinePattern::match(std::string_view line, std::span<std::string_view> found) const {
  std::array<re2::StringPiece, 1 + groups_at_once> pieces;
  std::size_t place = 0;
  for (const Part& part : parts_) {
    if (!part.expression->Match({line.data(), line.size()}, 0, line.size(), RE2::ANCHOR_BOTH,
                                pieces.data(), static_cast<int>(1 + part.groups)))
      return false;
    for (std::size_t i = 1; i <= part.groups; ++i)
      found[place++] = std::string_view(pieces[i].data(), pieces[i].size());
  }
  return true;
}

}  // namespace drydock::wire::described
