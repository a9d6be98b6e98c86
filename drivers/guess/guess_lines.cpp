#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "drivers/guess/decimal_commas.hpp"
#include "drivers/guess/guess.hpp"
#include "drivers/guess/left_out.hpp"
#include "drivers/guess/line_form_text.hpp"
#include "drivers/guess/longest_line.hpp"
#include "drivers/guess/pattern_text.hpp"

/// Lines that no checksum proves: those that differ in their numbers alone are one message, and its
/// pattern is their text with a group for each number.
namespace drydock::guess {
namespace {

constexpr std::size_t fewest_lines = 4, most_forms = 16;

bool is_printable(std::string_view line) {
  return std::ranges::all_of(
      line, [](char c) { return (c >= ' ' && c <= '~') || c == '\t' || is_foreign(c); });
}

/// By the texts. Ends that are words, such as "OK" and "ERR" behind a comma, are none of them.
using Forms = std::map<std::vector<std::string>, LineForm>;

std::vector<std::string> key_of(const LineCut& cut) {
  std::vector<std::string> key = cut.texts;
  std::string& end = key.back();
  const bool is_word =
      end.size() > 1 && !is_letter(end[0]) && std::ranges::all_of(end.substr(1), is_letter);
  if (is_word && key.size() > 1) end.resize(1);
  return key;
}

/// The program refuses two patterns that one line could begin.
bool heads_meet(std::string_view a, std::string_view b) {
  return a.starts_with(b) || b.starts_with(a);
}

/// Those that came most often first, each with what differs from it in a word.
std::vector<LineForm> merged(const Forms& forms) {
  std::vector<LineForm> often, all;
  for (const auto& form : forms) often.push_back(form.second);
  std::ranges::stable_sort(often, std::ranges::greater{}, &LineForm::lines);
  for (LineForm& form : often)
    if (std::ranges::none_of(all, [&](LineForm& one) { return one.merge(form); }))
      all.push_back(std::move(form));
  std::ranges::stable_sort(all, std::ranges::greater{}, &LineForm::lines);
  return all;
}

LinesGuess forms_text(const Forms& forms, LeftOut& left_out, char point,
                      const std::string& size_key) {
  std::size_t described = 0;
  std::string out = "\n[protocol]\n# lines without a checksum\n" + size_key;
  if (point == ',') out += "decimal = \",\"\n";
  std::vector<std::string> heads;
  for (const LineForm& form : merged(forms)) {
    const bool seldom = !form.has_numbers() || form.lines < 2 || heads.size() == most_forms;
    const std::string head(seldom ? "" : head_of(form));
    const bool meets = std::ranges::any_of(heads, [&](auto& h) { return heads_meet(h, head); });
    const auto text = meets || seldom ? std::nullopt : form_text(form, heads.size() + 1, point);
    if (!text) {
      left_out.add(form.example, form.lines);
      continue;
    }
    heads.push_back(head);
    out += *text;
    described += form.lines;
  }
  if (heads.empty()) return {};
  return {out + left_out.text(), described};
}

}  // namespace

LinesGuess guess_lines(const std::vector<std::string_view>& lines) {
  if (lines.size() <= fewest_lines) return {};
  Forms forms;
  LeftOut left_out;
  const bool commas = have_decimal_commas(lines);
  for (std::size_t i = 1; i < lines.size(); ++i) {  // the first may have lost its beginning
    if (!is_printable(lines[i])) {
      left_out.add(lines[i]);
      continue;
    }
    const std::string line = commas ? with_points(lines[i]) : std::string(lines[i]);
    const LineCut cut = cut_at_numbers(line);
    forms[key_of(cut)].add(lines[i], cut);
  }
  if (forms.size() * 2 > lines.size()) return {};
  return forms_text(forms, left_out, commas ? ',' : '.', longest_key(lines));
}

}  // namespace drydock::guess
