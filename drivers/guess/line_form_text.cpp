#include "drivers/guess/line_form_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/guess/left_out.hpp"
#include "drivers/guess/pattern_text.hpp"

namespace drydock::guess {
namespace {

std::string_view head_of_text(std::string_view text) {
  const auto other = std::ranges::find_if(text, [](char c) { return c == '\t' || is_foreign(c); });
  return text.substr(0, std::min<std::size_t>(longest_head, other - text.begin()));
}

/// One of several texts; `first` may be a pattern, or empty.
template <class Texts>
std::string any_of(std::string first, const Texts& texts) {
  std::size_t count = first.empty() ? 0 : 1;
  for (const auto& text : texts) {
    first += (count++ > 0 ? "|" : "") + regex_of(text);
  }
  return count > 1 ? "(?:" + first + ")" : first;
}

/// The text before a number, with a blank if one always stands there.
std::string text_before(const LineForm& form, std::size_t column) {
  return form.usual(column) + (form.columns[column].fewest_blanks > 0 ? " " : "");
}

/// All that stood there, as a pattern.
std::string pattern_before(const LineForm& form, std::size_t column) {
  std::vector<std::string> texts;
  for (const auto& [text, times] : form.texts[column]) texts.push_back(text);
  return any_of({}, texts) + (form.columns[column].fewest_blanks > 0 ? " " : "");
}

/// `point`: what is before a fraction.
std::string number_pattern(const Numbers& column, std::size_t i, char point) {
  if (column.count == 0) return {};
  if (column.hexadecimal) return fmt::format("(?P<c{}>[0-9A-Fa-f]+)", i + 1);
  return fmt::format("(?P<c{}>{}?[0-9{}]+{})", i + 1, column.has_plus ? "[-+]" : "-", point,
                     column.has_exponent ? "(?:[eE][-+][0-9]+)?" : "");
}

std::string end_pattern(const LineForm& form) {
  constexpr std::size_t few = 8;
  std::vector<std::string> ends;
  for (const auto& [end, times] : form.texts.back()) ends.push_back(end);
  if (ends.size() <= few) return any_of({}, ends);
  return regex_of(ends.front().substr(0, 1)) + "[A-Za-z]+";
}

/// The line of the field, with the range of its values.
std::string field_text(const Numbers& column, std::size_t i) {
  const std::string form = column.hexadecimal
                               ? fmt::format("type = \"hex\", width = {}", column.digits)
                               : fmt::format("decimals = {}", column.decimals);
  return fmt::format("  {{ group = \"c{0}\", name = \"column_{0}\", {1} }},  # {2} to {3}{4}\n",
                     i + 1, form, column.low, column.high,
                     column.gaps.empty() ? "" : ", sometimes none");
}

}  // namespace

std::string head_of(const LineForm& form) {
  return std::string(head_of_text(text_before(form, 0)));
}

std::optional<std::string> form_text(const LineForm& form, std::size_t number, char point) {
  const std::string begin = text_before(form, 0);
  const std::string_view head = head_of_text(begin),
                         behind = std::string_view(begin).substr(head.size());
  std::string pattern = regex_of(behind), emulate = with_double_brackets(behind), fields;
  for (std::size_t i = 0; i < form.columns.size(); ++i) {
    const Numbers& column = form.columns[i];
    const bool is_last = i + 1 == form.columns.size();
    const std::string next = is_last ? form.usual(i + 1) : text_before(form, i + 1);
    if (column.most_blanks > 0) pattern += pattern.ends_with(' ') ? "+" : " *";
    pattern += any_of(number_pattern(column, i, point), column.gaps);
    pattern += is_last ? end_pattern(form) : pattern_before(form, i + 1);
    emulate += column.count > 0 ? fmt::format("{{c{}}}", i + 1) : *column.gaps.begin();
    emulate += with_double_brackets(next);
    if (column.count > 0) fields += field_text(column, i);
  }
  if (std::max(pattern.size(), emulate.size()) > longest_pattern) return {};
  return fmt::format(
      "\n[[protocol.lines]]             # {} times, as {}\nname = \"line_{}\"\nhead = \"{}\"\n"
      "pattern = '{}'\nemulate = \"{}\"\nfields = [\n{}]\n",
      form.lines, in_comment(form.example), number, escaped(head), pattern, escaped(emulate),
      fields);
}

}  // namespace drydock::guess
