#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "drivers/survey/guess.hpp"
#include "drivers/survey/left_out.hpp"
#include "drivers/wire/text_fields.hpp"

/// Lines that no checksum proves: those that differ in their numbers alone are one message, and its
/// pattern is their text with a group for each number.
namespace drydock::survey {
namespace {

constexpr std::size_t most_groups = 32, most_decimals = 12, fewest_lines = 4, most_forms = 16;

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
/// A description has no other characters.
bool is_printable(std::string_view line) {
  return std::ranges::all_of(line, [](char c) { return (c >= ' ' && c <= '~') || c == '\t'; });
}
constexpr bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

/// The text between the numbers of a line (one more than there are numbers), and the numbers.
struct Cut {
  std::vector<std::string> texts{""};
  std::vector<std::string_view> numbers;
};

/// Characters of "e-05" behind the digits of a number; 0: there is no exponent.
std::size_t exponent_at(std::string_view text) {
  if (text.size() < 3 || (text[0] != 'e' && text[0] != 'E')) return 0;
  if (text[1] != '-' && text[1] != '+') return 0;  // "12E" is 12 and a letter
  std::size_t i = 2;
  while (i < text.size() && is_digit(text[i])) ++i;
  return i > 2 ? i : 0;
}

/// Characters of the number that begins here; 0: none does. A sign belongs to it where nothing
/// that a minus could join stands before.
std::size_t number_at(std::string_view line, std::size_t at) {
  const char before = at == 0 ? ' ' : line[at - 1];
  std::size_t i = at;
  if ((line[i] == '-' || line[i] == '+') && !is_digit(before) && !is_letter(before)) ++i;
  const std::size_t digits = i;
  while (i < line.size() && is_digit(line[i])) ++i;
  if (i == digits) return 0;
  const bool has_point = i + 1 < line.size() && line[i] == '.' && is_digit(line[i + 1]);
  // "T1" is a name, "D0012.3" and "D0012" are a letter and a number.
  constexpr std::size_t longest_name = 2;
  if (is_letter(before) && !has_point && i - digits <= longest_name) return 0;
  if (has_point) ++i;
  while (has_point && i < line.size() && is_digit(line[i])) ++i;
  return i + exponent_at(line.substr(i)) - at;
}

Cut cut_at_numbers(std::string_view line) {
  Cut cut;
  for (std::size_t i = 0; i < line.size();) {
    const std::size_t size = cut.numbers.size() < most_groups ? number_at(line, i) : 0;
    if (size == 0) {
      // The digits of a name are not looked at one by one.
      do cut.texts.back() += line[i++];
      while (i < line.size() && is_digit(line[i]) && is_digit(line[i - 1]));
      continue;
    }
    cut.numbers.push_back(line.substr(i, size));
    cut.texts.emplace_back();
    i += size;
  }
  return cut;
}

struct Numbers {
  double low = 0, high = 0;
  std::size_t decimals = 0;
  bool has_plus = false, has_exponent = false;
};

/// All lines with the same texts.
struct Form {
  std::size_t lines = 0;
  std::string example;
  std::vector<Numbers> columns;

  void add(std::string_view line, const Cut& cut) {
    if (lines++ == 0) {
      example = line;
      columns.resize(cut.numbers.size());
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      Numbers& column = columns[i];
      const std::string_view text = cut.numbers[i];
      const double number = wire::parse_number(text).value_or(0);
      column.low = lines == 1 ? number : std::min(column.low, number);
      column.high = lines == 1 ? number : std::max(column.high, number);
      column.has_plus |= text[0] == '+';
      const std::size_t power = std::min(text.find_first_of("eE"), text.size());
      column.has_exponent |= power < text.size();
      const std::size_t point = text.find('.');
      if (point != text.npos)
        column.decimals = std::clamp(power - point - 1, column.decimals, most_decimals);
    }
  }
};

using Forms = std::map<std::vector<std::string>, Form>;
using OneForm = Forms::value_type;

/// Text as RE2 takes it literally, inside a literal string of TOML, which has no apostrophe.
std::string regex_of(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'' || c == '\t')
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
  return text.substr(0, std::min(longest_head, text.find('\t')));
}

/// Nothing if the pattern is too long for a description.
std::optional<std::string> form_text(const OneForm& one, std::size_t number) {
  const auto& [texts, form] = one;
  const std::string_view head = head_of(texts[0]),
                         behind = std::string_view(texts[0]).substr(head.size());
  std::string pattern = regex_of(behind), emulate(behind), fields;
  for (std::size_t i = 0; i < form.columns.size(); ++i) {
    const Numbers& column = form.columns[i];
    pattern +=
        fmt::format("(?P<c{}>{}?[0-9.]+{}){}", i + 1, column.has_plus ? "[-+]" : "-",
                    column.has_exponent ? "(?:[eE][-+][0-9]+)?" : "", regex_of(texts[i + 1]));
    emulate += fmt::format("{{c{}}}{}", i + 1, texts[i + 1]);
    fields += fmt::format(
        "  {{ group = \"c{0}\", name = \"column_{0}\", decimals = {1} }},  # {2} to {3}\n", i + 1,
        column.decimals, column.low, column.high);
  }
  if (std::max(pattern.size(), emulate.size()) > longest_pattern) return {};
  return fmt::format(
      "\n[[protocol.lines]]             # {} times, as {}\nname = \"line_{}\"\nhead = \"{}\"\n"
      "pattern = '{}'\nemulate = \"{}\"\nfields = [\n{}]\n",
      form.lines, form.example, number, escaped(head), pattern, escaped(emulate), fields);
}

/// The program refuses two patterns that one line could begin.
bool heads_meet(std::string_view a, std::string_view b) {
  return a.starts_with(b) || b.starts_with(a);
}

std::string forms_text(const Forms& forms, LeftOut& left_out) {
  std::vector<const OneForm*> often;
  for (const auto& form : forms) often.push_back(&form);
  std::ranges::stable_sort(often, std::ranges::greater{},
                           [](auto* one) { return one->second.lines; });
  std::string out = "\n[protocol]\n# lines without a checksum\n";
  std::vector<std::string_view> heads;
  for (const OneForm* one : often) {
    const auto& [texts, form] = *one;
    const std::string_view head = head_of(texts[0]);
    const bool meets = std::ranges::any_of(heads, [&](auto h) { return heads_meet(h, head); });
    const bool seldom = form.columns.empty() || form.lines < 2 || heads.size() == most_forms;
    const auto text = meets || seldom ? std::nullopt : form_text(*one, heads.size() + 1);
    if (!text) {
      left_out.add(form.example, form.lines);
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
  for (std::size_t i = 1; i < lines.size(); ++i) {  // the first may have lost its beginning
    if (!is_printable(lines[i])) {
      left_out.add(lines[i]);
      continue;
    }
    Cut cut = cut_at_numbers(lines[i]);
    forms[cut.texts].add(lines[i], cut);
  }
  return forms.size() * 2 > lines.size() ? std::string() : forms_text(forms, left_out);
}

}  // namespace drydock::survey
