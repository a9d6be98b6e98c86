#include "drivers/guess/line_form.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>

#include "drivers/wire/text_fields.hpp"

namespace drydock::guess {
namespace {

constexpr std::size_t most_decimals = 12;

std::optional<double> number_of(std::string_view text, bool hexadecimal) {
  if (!hexadecimal) return wire::parse_number(text);
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (error != std::errc{} || stop != text.data() + text.size()) return {};
  return static_cast<double>(value);
}

constexpr bool is_of_word(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

/// True if the texts differ in one word that is a value: "ok":true,"t": and "ok":false,"t":. A word
/// at the number is its name, and another name is another message: "depth": and "temp":.
bool differ_in_a_value(std::string_view a, std::string_view b, bool at_end) {
  const auto mismatch = std::ranges::mismatch(a, b);
  auto before = static_cast<std::size_t>(mismatch.in1 - a.begin());
  while (before > 0 && is_of_word(a[before - 1])) --before;
  std::size_t behind = 0;
  const std::size_t most = std::min(a.size(), b.size()) - before;
  while (behind < most && a[a.size() - 1 - behind] == b[b.size() - 1 - behind]) ++behind;
  while (behind > 0 && is_of_word(a[a.size() - behind])) --behind;
  constexpr std::size_t longest_word = 12;
  const std::string_view one = a.substr(before, a.size() - behind - before),
                         other = b.substr(before, b.size() - behind - before);
  if (std::max(one.size(), other.size()) > longest_word) return false;
  if (at_end) return true;
  const auto is_word = [](std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, is_letter);
  };
  if (!is_word(one) || !is_word(other)) return false;
  const std::string_view rest = a.substr(a.size() - behind);
  const bool ends_field = !rest.empty() && std::string_view(",;\t").find(rest[0]) != rest.npos;
  return ends_field || std::ranges::any_of(rest, is_letter);
}

}  // namespace

void Numbers::add(std::string_view text, std::size_t blanks, bool is_hexadecimal) {
  fewest_blanks = std::min(fewest_blanks, blanks);
  most_blanks = std::max(most_blanks, blanks);
  const auto number = number_of(text, is_hexadecimal);
  if (!number) {
    gaps.emplace(text);
    return;
  }
  low = count == 0 ? *number : std::min(low, *number);
  high = count == 0 ? *number : std::max(high, *number);
  ++count;
  hexadecimal |= is_hexadecimal;
  digits = std::max(digits, text.size());
  has_plus |= text[0] == '+';
  if (is_hexadecimal) return;
  const std::size_t power = std::min(text.find_first_of("eE"), text.size());
  has_exponent |= power < text.size();
  const std::size_t point = text.find('.');
  if (point != text.npos) decimals = std::clamp(power - point - 1, decimals, most_decimals);
}

void Numbers::add(const Numbers& others) {
  if (others.count > 0) {
    low = count == 0 ? others.low : std::min(low, others.low);
    high = count == 0 ? others.high : std::max(high, others.high);
  }
  count += others.count;
  decimals = std::max(decimals, others.decimals);
  digits = std::max(digits, others.digits);
  hexadecimal |= others.hexadecimal;
  has_plus |= others.has_plus;
  has_exponent |= others.has_exponent;
  fewest_blanks = std::min(fewest_blanks, others.fewest_blanks);
  most_blanks = std::max(most_blanks, others.most_blanks);
  gaps.insert(others.gaps.begin(), others.gaps.end());
}

void LineForm::add(std::string_view line, const LineCut& cut) {
  if (lines++ == 0) {
    example = line;
    texts.resize(cut.texts.size());
    columns.resize(cut.numbers.size());
  }
  for (std::size_t i = 0; i < texts.size(); ++i) ++texts[i][cut.texts[i]];
  for (std::size_t i = 0; i < columns.size(); ++i)
    columns[i].add(cut.numbers[i], cut.blanks[i], cut.hexadecimal[i]);
}

bool LineForm::merge(const LineForm& other) {
  if (columns.size() != other.columns.size() || columns.empty()) return false;
  if (usual(0) != other.usual(0)) return false;
  for (std::size_t i = 1; i < texts.size(); ++i) {
    const bool at_end = i + 1 == texts.size();
    const std::string &mine = usual(i), &others = other.usual(i);
    if (mine != others && !differ_in_a_value(mine, others, at_end)) return false;
    if (!at_end && texts[i].size() == most_words && !texts[i].contains(others)) return false;
  }
  for (std::size_t i = 0; i < texts.size(); ++i)
    for (const auto& [text, times] : other.texts[i]) texts[i][text] += times;
  for (std::size_t i = 0; i < columns.size(); ++i) columns[i].add(other.columns[i]);
  lines += other.lines;
  return true;
}

bool LineForm::has_numbers() const {
  return std::ranges::any_of(columns, [](const Numbers& column) { return column.count > 0; });
}

const std::string& LineForm::usual(std::size_t place) const {
  return std::ranges::max_element(texts[place], {}, [](const auto& text) { return text.second; })
      ->first;
}

}  // namespace drydock::guess
