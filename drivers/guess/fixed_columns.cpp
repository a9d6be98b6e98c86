#include "drivers/guess/fixed_columns.hpp"

#include <algorithm>
#include <set>

#include "drivers/guess/hex_columns.hpp"
#include "drivers/guess/line_cut.hpp"

namespace drydock::guess {
namespace {

using Holds = FixedColumn::Holds;
using Lines = std::vector<std::string_view>;

/// What stood at each place.
class Places {
 public:
  explicit Places(const Lines& lines) : sets_(lines.front().size()) {
    for (const std::string_view line : lines)
      for (std::size_t at = 0; at < line.size(); ++at) sets_[at].insert(line[at]);
  }

  std::size_t size() const { return sets_.size(); }
  bool is_constant(std::size_t at) const { return sets_[at].size() == 1; }
  bool is_any_of(std::size_t at, std::string_view chars) const {
    return std::ranges::all_of(sets_[at], [&](char c) { return chars.find(c) != chars.npos; });
  }
  bool is_digit_at(std::size_t at) const { return is_any_of(at, digits); }
  bool is_hex(std::size_t at) const {
    return is_any_of(at, "0123456789ABCDEF") || is_any_of(at, "0123456789abcdef");
  }
  /// A digit of a hexadecimal number, and of no other.
  bool is_only_hex(std::size_t at) const {
    return is_hex(at) && !is_digit_at(at) && std::ranges::any_of(sets_[at], is_digit);
  }
  bool is_sign_or_digit(std::size_t at) const { return is_any_of(at, "0123456789+- "); }

  /// A run of hexadecimal digits, but for letters at its ends that never change; 0: none.
  FixedColumn hexadecimal_at(std::size_t at) const {
    std::size_t end = at;
    bool found = false;
    if (is_constant(at) && !is_digit_at(at)) return {};
    for (; end < size() && is_hex(end); ++end) found |= is_only_hex(end);
    while (end > at && is_constant(end - 1) && !is_digit_at(end - 1)) --end;
    return found ? FixedColumn{Holds::hexadecimal, at, end - at} : FixedColumn{};
  }

  /// Digits, with a sign or blanks before them and a point among them. The sign of a number begins
  /// it; blanks that never change stand between columns.
  FixedColumn number_at(std::size_t at) const {
    const bool joins = at > 0 && is_digit_at(at - 1) && is_any_of(at, "-");  // as in a date
    if (joins || is_any_of(at, " ") || !is_sign_or_digit(at)) return {};
    std::size_t end = at;
    while (end < size() && is_sign_or_digit(end) && !is_digit_at(end) &&
           (end == at || !is_any_of(end, "+- ")))
      ++end;
    bool changes = end > at && !is_constant(at);
    const std::size_t first = end;
    for (; end < size(); ++end) {
      const bool is_point =
          end > first && end + 1 < size() && is_any_of(end, ".") && is_digit_at(end + 1);
      if (!is_point && !is_digit_at(end)) break;
      changes |= !is_constant(end);
    }
    return changes && end > first ? FixedColumn{Holds::number, at, end - at} : FixedColumn{};
  }

 private:
  static constexpr std::string_view digits = "0123456789";
  std::vector<std::set<char>> sets_;
};

void add_hexadecimal(const Lines& lines, const FixedColumn& run, std::vector<FixedColumn>& into) {
  Lines texts;
  for (const std::string_view line : lines) texts.push_back(line.substr(run.at, run.size));
  std::size_t at = run.at;
  for (const std::size_t size : hex_columns(texts)) {
    into.push_back({Holds::hexadecimal, at, size});
    at += size;
  }
}

}  // namespace

std::vector<FixedColumn> fixed_columns(const Lines& lines) {
  constexpr std::size_t longest_text = 2;  // a letter of the state, not words
  const Places places(lines);
  std::vector<FixedColumn> columns;
  for (std::size_t at = 0; at < places.size();) {
    const FixedColumn hexadecimal = places.hexadecimal_at(at);
    const FixedColumn number = hexadecimal.size > 0 ? FixedColumn{} : places.number_at(at);
    if (hexadecimal.size > 0) {
      add_hexadecimal(lines, hexadecimal, columns);
    } else if (number.size > 0) {
      columns.push_back(number);
    } else {
      const Holds holds = places.is_constant(at) ? Holds::constant : Holds::text;
      if (columns.empty() || columns.back().holds != holds) columns.push_back({holds, at, 0});
      if (++columns.back().size > longest_text && holds == Holds::text) return {};
    }
    at = columns.back().at + columns.back().size;
  }
  return columns;
}

}  // namespace drydock::guess
