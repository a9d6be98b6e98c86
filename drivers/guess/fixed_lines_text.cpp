#include <fmt/format.h>

#include <algorithm>

#include "drivers/guess/fixed_columns.hpp"
#include "drivers/guess/left_out.hpp"
#include "drivers/guess/line_cut.hpp"
#include "drivers/guess/pattern_text.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::guess {
namespace {

using Holds = FixedColumn::Holds;
using Lines = std::vector<std::string_view>;

std::string_view without_blanks_before(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

/// "# 0 to 300", of those that are numbers.
std::string range_text(const Lines& lines, const FixedColumn& column) {
  double low = 0, high = 0;
  bool any = false;
  for (const std::string_view line : lines) {
    const auto number =
        wire::parse_number(without_blanks_before(line.substr(column.at, column.size)));
    if (!number) continue;
    low = any ? std::min(low, *number) : *number;
    high = any ? std::max(high, *number) : *number;
    any = true;
  }
  return any ? fmt::format("  # {} to {}", low, high) : std::string();
}

/// What may stand at one place of a number.
std::string place_pattern(const Lines& lines, std::size_t at) {
  bool digits = false, minus = false, plus = false, blank = false, point = false;
  for (const std::string_view line : lines) {
    digits |= is_digit(line[at]);
    minus |= line[at] == '-';
    plus |= line[at] == '+';
    blank |= line[at] == ' ';
    point |= line[at] == '.';
  }
  if (point) return "\\.";
  if (digits && !minus && !plus && !blank) return "[0-9]";
  blank |= !plus && !digits;  // in the place of a minus
  return fmt::format("[-{}{}{}]", plus ? "+" : "", blank ? " " : "", digits ? "0-9" : "");
}

std::string number_pattern_of(const Lines& lines, const FixedColumn& column) {
  std::string pattern;
  for (std::size_t at = column.at, times = 1; at < column.at + column.size; at += times) {
    const std::string one = place_pattern(lines, at);
    times = 1;
    while (at + times < column.at + column.size && place_pattern(lines, at + times) == one) ++times;
    pattern += times > 1 ? fmt::format("{}{{{}}}", one, times) : one;
  }
  return pattern;
}

/// How an emulated device writes the number.
std::string number_form(const Lines& lines, const FixedColumn& column) {
  const std::string first = place_pattern(lines, column.at);
  const bool has_sign = first.find("0-9") == first.npos;
  const std::string_view text = lines.front().substr(column.at, column.size);
  const std::size_t point = text.find('.');
  return fmt::format("decimals = {}, width = {}{}",
                     point == text.npos ? std::size_t{0} : text.size() - point - 1, column.size,
                     !has_sign                       ? ""
                     : first.find('+') != first.npos ? ", sign = \"+\""
                     : first.find(' ') != first.npos ? ", sign = \" \""
                                                     : "");
}

struct Group {
  std::string pattern, form, range;
};

Group group_of(const Lines& lines, const FixedColumn& column) {
  if (column.holds == Holds::number)
    return {number_pattern_of(lines, column), number_form(lines, column),
            range_text(lines, column)};
  if (column.holds == Holds::hexadecimal)
    return {fmt::format("[0-9A-Fa-f]{{{}}}", column.size),
            fmt::format("type = \"hex\", width = {}", column.size),
            {}};
  const std::string example(lines.front().substr(column.at, column.size));
  return {column.size == 1 ? "[ -~]" : fmt::format("[ -~]{{{}}}", column.size),
          fmt::format("type = \"text\", emulate = \"{}\"", escaped(example)),
          {}};
}

}  // namespace

std::optional<std::string> fixed_lines_text(const Lines& lines) {
  const auto columns = fixed_columns(lines);
  std::string head, pattern, emulate, fields;
  std::size_t groups = 0, numbers = 0;
  for (const FixedColumn& column : columns) {
    const std::string_view text = lines.front().substr(column.at, column.size);
    if (column.holds == Holds::constant) {
      const std::size_t in_head = groups > 0 ? 0 : std::min(text.size(), longest_head);
      head += text.substr(0, in_head);
      pattern += regex_of(text.substr(in_head));
      emulate += with_double_brackets(text.substr(in_head));
      continue;
    }
    const Group group = group_of(lines, column);
    numbers += column.holds != Holds::text;
    ++groups;
    pattern += fmt::format("(?P<c{}>{})", groups, group.pattern);
    emulate += fmt::format("{{c{}}}", groups);
    fields += fmt::format("  {{ group = \"c{0}\", name = \"column_{0}\", {1} }},{2}\n", groups,
                          group.form, group.range);
  }
  if (numbers == 0 || groups > most_groups) return {};
  if (std::max(pattern.size(), emulate.size()) > longest_pattern) return {};
  return fmt::format(
      "\n[[protocol.lines]]             # {} times, as {}\nname = \"line_1\"\nhead = \"{}\"\n"
      "pattern = '{}'\nemulate = \"{}\"\nfields = [\n{}]\n",
      lines.size(), in_comment(lines.front()), escaped(head), pattern, escaped(emulate), fields);
}

}  // namespace drydock::guess
