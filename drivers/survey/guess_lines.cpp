#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "drivers/survey/decimal_commas.hpp"
#include "drivers/survey/guess.hpp"
#include "drivers/survey/left_out.hpp"
#include "drivers/survey/line_cut.hpp"
#include "drivers/wire/text_fields.hpp"

/// Lines that no checksum proves: those that differ in their numbers alone are one message, and its
/// pattern is their text with a group for each number.
namespace drydock::survey {
namespace {

constexpr std::size_t most_decimals = 12, fewest_lines = 4, most_forms = 16;

/// A letter that is not of ASCII, such as a degree sign, or a byte of one.
constexpr bool is_foreign(char c) { return static_cast<unsigned char>(c) >= 0x80; }
bool is_printable(std::string_view line) {
  return std::ranges::all_of(
      line, [](char c) { return (c >= ' ' && c <= '~') || c == '\t' || is_foreign(c); });
}

/// What stood at one place of the lines.
struct Numbers {
  std::size_t count = 0;
  double low = 0, high = 0;
  std::size_t decimals = 0;
  bool has_plus = false, has_exponent = false;
  std::size_t fewest_blanks = most_groups, most_blanks = 0;  ///< before it
  std::set<std::string, std::less<>> gaps;                   ///< in the place of a number

  void add(std::string_view text, std::size_t blanks) {
    fewest_blanks = std::min(fewest_blanks, blanks);
    most_blanks = std::max(most_blanks, blanks);
    const auto number = wire::parse_number(text);
    if (!number) {
      gaps.emplace(text);
      return;
    }
    low = count == 0 ? *number : std::min(low, *number);
    high = count == 0 ? *number : std::max(high, *number);
    ++count;
    has_plus |= text[0] == '+';
    const std::size_t power = std::min(text.find_first_of("eE"), text.size());
    has_exponent |= power < text.size();
    const std::size_t point = text.find('.');
    if (point != text.npos) decimals = std::clamp(power - point - 1, decimals, most_decimals);
  }
};

/// All lines with the same texts but for their ends.
struct Form {
  std::size_t lines = 0;
  std::string example;
  std::vector<std::string> texts;           ///< of the first
  std::map<std::string, std::size_t> ends;  ///< and how often
  std::vector<Numbers> columns;

  void add(std::string_view line, const LineCut& cut) {
    if (lines++ == 0) {
      example = line;
      texts = cut.texts;
      columns.resize(cut.numbers.size());
    }
    ++ends[cut.texts.back()];
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].add(cut.numbers[i], cut.blanks[i]);
  }
  bool has_numbers() const {
    return std::ranges::any_of(columns, [](const Numbers& column) { return column.count > 0; });
  }
};

/// By the texts. Ends that are words, such as "OK" and "ERR" behind a comma, are none of them.
using Forms = std::map<std::vector<std::string>, Form>;

std::vector<std::string> key_of(const LineCut& cut) {
  std::vector<std::string> key = cut.texts;
  std::string& end = key.back();
  const bool is_word =
      end.size() > 1 && !is_letter(end[0]) && std::ranges::all_of(end.substr(1), is_letter);
  if (is_word && key.size() > 1) end.resize(1);
  return key;
}

/// Text as RE2 takes it literally, inside a literal string of TOML, which has no apostrophe.
/// Letters that are not of ASCII may be any, and may be left out.
std::string regex_of(std::string_view text) {
  constexpr std::string_view foreign = "[^ -~]*";
  std::string out;
  for (const char c : text) {
    if (is_foreign(c))
      out += out.ends_with(foreign) ? std::string_view() : foreign;
    else if (c == '\'' || c == '\t')
      out += fmt::format("\\x{:02x}", static_cast<unsigned>(c));
    else if (is_letter(c) || is_digit(c) ||
             std::string_view(" ,;:=#%&/<>@_~\"!").find(c) != std::string_view::npos)
      out += c;
    else
      out += {'\\', c};
  }
  return out;
}

/// In a basic string of TOML.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (is_foreign(c)) continue;
    if (c == '\t') {
      out += "\\t";
      continue;
    }
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

/// What a description takes: rig_config/schema/device.schema.json.
constexpr std::size_t longest_head = 32, longest_pattern = 512;

std::string_view head_of(std::string_view text) {
  const auto other = std::ranges::find_if(text, [](char c) { return c == '\t' || is_foreign(c); });
  return text.substr(0, std::min<std::size_t>(longest_head, other - text.begin()));
}

/// The text before a number, with a blank if one always stands there.
std::string text_before(const Form& form, std::size_t column) {
  return form.texts[column] + (form.columns[column].fewest_blanks > 0 ? " " : "");
}

/// `point`: what is before a fraction.
std::string number_pattern(const Numbers& column, std::size_t i, char point) {
  if (column.count == 0) return {};
  return fmt::format("(?P<c{}>{}?[0-9{}]+{})", i + 1, column.has_plus ? "[-+]" : "-", point,
                     column.has_exponent ? "(?:[eE][-+][0-9]+)?" : "");
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

/// The end that came most often is what the emulated device sends.
std::string usual_end(const Form& form) {
  return std::ranges::max_element(form.ends, {}, [](const auto& end) { return end.second; })->first;
}

std::string end_pattern(const Form& form) {
  constexpr std::size_t few = 8;
  std::vector<std::string> ends;
  for (const auto& [end, lines] : form.ends) ends.push_back(end);
  if (ends.size() <= few) return any_of({}, ends);
  return regex_of(ends.front().substr(0, 1)) + "[A-Za-z]+";
}

/// Nothing if the pattern is too long for a description.
std::optional<std::string> form_text(const Form& form, std::size_t number, char point) {
  const std::string begin = text_before(form, 0), end = usual_end(form);
  const std::string_view head = head_of(begin),
                         behind = std::string_view(begin).substr(head.size());
  std::string pattern = regex_of(behind), emulate(behind), fields;
  for (std::size_t i = 0; i < form.columns.size(); ++i) {
    const Numbers& column = form.columns[i];
    const bool is_last = i + 1 == form.columns.size();
    const std::string next = is_last ? end : text_before(form, i + 1);
    if (column.most_blanks > 0) pattern += pattern.ends_with(' ') ? "+" : " *";
    pattern += any_of(number_pattern(column, i, point), column.gaps);
    pattern += is_last ? end_pattern(form) : regex_of(next);
    emulate += column.count > 0 ? fmt::format("{{c{}}}", i + 1) : *column.gaps.begin();
    emulate += next;
    if (column.count == 0) continue;
    fields += fmt::format(
        "  {{ group = \"c{0}\", name = \"column_{0}\", decimals = {1} }},  # {2} to {3}{4}\n",
        i + 1, column.decimals, column.low, column.high,
        column.gaps.empty() ? "" : ", sometimes none");
  }
  if (std::max(pattern.size(), emulate.size()) > longest_pattern) return {};
  return fmt::format(
      "\n[[protocol.lines]]             # {} times, as {}\nname = \"line_{}\"\nhead = \"{}\"\n"
      "pattern = '{}'\nemulate = \"{}\"\nfields = [\n{}]\n",
      form.lines, in_comment(form.example), number, escaped(head), pattern, escaped(emulate),
      fields);
}

/// The program refuses two patterns that one line could begin.
bool heads_meet(std::string_view a, std::string_view b) {
  return a.starts_with(b) || b.starts_with(a);
}

std::string forms_text(const Forms& forms, LeftOut& left_out, char point) {
  std::vector<const Form*> often;
  for (const auto& form : forms) often.push_back(&form.second);
  std::ranges::stable_sort(often, std::ranges::greater{}, &Form::lines);
  std::string out = "\n[protocol]\n# lines without a checksum\n";
  if (point == ',') out += "decimal = \",\"\n";
  std::vector<std::string> heads;
  for (const Form* form : often) {
    const bool seldom = !form->has_numbers() || form->lines < 2 || heads.size() == most_forms;
    const std::string head(seldom ? "" : head_of(text_before(*form, 0)));
    const bool meets = std::ranges::any_of(heads, [&](auto& h) { return heads_meet(h, head); });
    const auto text = meets || seldom ? std::nullopt : form_text(*form, heads.size() + 1, point);
    if (!text) {
      left_out.add(form->example, form->lines);
      continue;
    }
    heads.push_back(head);
    out += *text;
  }
  if (heads.empty()) return {};
  return out + left_out.text();
}

}  // namespace

std::string guess_lines(const std::vector<std::string_view>& lines) {
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
  return forms.size() * 2 > lines.size() ? std::string()
                                         : forms_text(forms, left_out, commas ? ',' : '.');
}

}  // namespace drydock::survey
