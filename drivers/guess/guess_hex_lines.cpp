#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "drivers/guess/guess.hpp"
#include "drivers/guess/hex_columns.hpp"
#include "drivers/guess/left_out.hpp"
#include "drivers/guess/line_cut.hpp"

/// Lines of hexadecimal digits without anything between their columns, as some CTDs send them.
namespace drydock::guess {
namespace {

constexpr std::size_t fewest_hex_lines = 8, fewest_digits = 6;

bool is_hex(std::string_view line) { return std::ranges::all_of(line, is_hex_digit); }
bool has_letters(std::string_view line) { return std::ranges::any_of(line, is_letter); }

/// What stands before the digits of every line, as a colon.
std::string_view prefix_of(const std::vector<std::string_view>& lines) {
  std::string_view same = lines.front();
  for (const std::string_view line : lines)
    same = same.substr(
        0, static_cast<std::size_t>(std::ranges::mismatch(same, line).in1 - same.begin()));
  while (!same.empty() && is_hex_digit(same.back())) same.remove_suffix(1);
  constexpr std::size_t longest = 8;
  const bool plain = std::ranges::all_of(
      same, [](char c) { return c > ' ' && c <= '~' && c != '"' && c != '\\'; });
  return plain && same.size() <= longest ? same : std::string_view();
}

}  // namespace

std::string guess_hex_lines(const std::vector<std::string_view>& all) {
  if (all.size() <= fewest_hex_lines) return {};
  std::vector<std::string_view> lines(all.begin() + 1, all.end());  // the first may be cut
  const std::string example = in_comment(lines.front());
  const std::string_view head = prefix_of(lines);
  for (std::string_view& line : lines) line.remove_prefix(head.size());
  const std::size_t size = lines.front().size();
  const bool same = std::ranges::all_of(
      lines, [&](std::string_view line) { return line.size() == size && is_hex(line); });
  if (!same || size < fewest_digits || std::ranges::none_of(lines, has_letters)) return {};
  const auto columns = hex_columns(lines);
  if (columns.size() > most_groups) return {};
  std::string pattern, emulate, fields;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    pattern += fmt::format("(?P<c{}>[0-9A-Fa-f]{{{}}})", i + 1, columns[i]);
    emulate += fmt::format("{{c{}}}", i + 1);
    fields += fmt::format(
        "  {{ group = \"c{0}\", name = \"column_{0}\", type = \"hex\", width = {1} }},\n", i + 1,
        columns[i]);
  }
  return fmt::format(
      "\n[protocol]\n# lines of hexadecimal digits; a column ends where a digit that changes often "
      "is\n# followed by one that seldom does. hex_signed is the type of a number that can be "
      "negative.\n\n[[protocol.lines]]             # {} times, as {}\nname = \"line_1\"\nhead = "
      "\"{}\"\npattern = '{}'\nemulate = \"{}\"\nfields = [\n{}]\n",
      lines.size(), example, head, pattern, emulate, fields);
}

}  // namespace drydock::guess
