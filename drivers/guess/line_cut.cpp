#include "drivers/guess/line_cut.hpp"

#include <algorithm>

namespace drydock::guess {
namespace {

/// Characters of "e-05" behind the digits of a number; 0: there is no exponent.
std::size_t exponent_at(std::string_view text) {
  if (text.size() < 3 || (text[0] != 'e' && text[0] != 'E')) return 0;
  if (text[1] != '-' && text[1] != '+') return 0;  // "12E" is 12 and a letter
  std::size_t i = 2;
  while (i < text.size() && is_digit(text[i])) ++i;
  return i > 2 ? i : 0;
}

/// A sign belongs to the number where nothing that a minus could join stands before: "D-0.5" and
/// "D-5" have a letter and a number, and so has "P-5" behind the number of "H0484P-5", which ends
/// at `number_end`; "COM-1" is a name.
bool is_sign(std::string_view line, std::size_t at, std::size_t number_end) {
  if (line[at] != '-' && line[at] != '+') return false;
  if (at == 0 || (!is_digit(line[at - 1]) && !is_letter(line[at - 1]))) return true;
  if (is_digit(line[at - 1])) return false;
  const std::size_t behind = line.find_first_not_of("0123456789", at + 1);
  const bool has_point = behind != line.npos && line[behind] == '.';
  const bool letter_alone = at < 2 || (!is_letter(line[at - 2]) && !is_digit(line[at - 2]));
  const bool behind_number = at >= 2 && number_end + 1 == at;
  return has_point || letter_alone || behind_number;
}

/// True if 0x stands here, and a hexadecimal digit behind it.
bool is_hex_prefix(std::string_view line, std::size_t at) {
  const bool inside = at > 0 && (is_digit(line[at - 1]) || is_letter(line[at - 1]));
  return !inside && at + 2 < line.size() && line[at] == '0' &&
         (line[at + 1] == 'x' || line[at + 1] == 'X') && is_hex_digit(line[at + 2]);
}

bool is_behind_hex_prefix(std::string_view line, std::size_t at) {
  return at >= 2 && is_hex_prefix(line, at - 2);
}

/// True for the hour of `2014-08-01T00:05:12`, which may be the same in a whole capture.
bool is_hour(std::string_view line, std::size_t at) {
  const std::string_view hour = line.substr(at, 3);
  return at >= 2 && line[at - 1] == 'T' && is_digit(line[at - 2]) && hour.size() == 3 &&
         is_digit(hour[0]) && is_digit(hour[1]) && hour[2] == ':';
}

/// Characters of the number that begins here; 0: none does.
std::size_t number_at(std::string_view line, std::size_t at, std::size_t number_end) {
  if (is_hex_prefix(line, at)) return 0;
  if (is_behind_hex_prefix(line, at)) {
    std::size_t stop = at;
    while (stop < line.size() && is_hex_digit(line[stop])) ++stop;
    return stop - at;
  }
  const char before = at == 0 ? ' ' : line[at - 1];
  const bool has_sign = is_sign(line, at, number_end);
  const std::size_t digits = at + (has_sign ? 1 : 0);
  std::size_t i = digits;
  while (i < line.size() && is_digit(line[i])) ++i;
  if (i == digits) return 0;
  const bool has_point = i + 1 < line.size() && line[i] == '.' && is_digit(line[i + 1]);
  // "T1" is a name, "D0012.3" and "D0012" are a letter and a number, and so has "2014-08-01T00:".
  constexpr std::size_t longest_name = 2;
  if (is_letter(before) && !is_hour(line, at) && !has_sign && !has_point &&
      i - digits <= longest_name)
    return 0;
  if (has_point) ++i;
  while (has_point && i < line.size() && is_digit(line[i])) ++i;
  return i + exponent_at(line.substr(i)) - at;
}

/// Characters of what stands for a number that is not there: "NaN", "----.-", "***"; 0: none does.
std::size_t gap_at(std::string_view line, std::size_t at) {
  constexpr std::string_view separators = " ,;:=|\t";
  if (at > 0 && separators.find(line[at - 1]) == separators.npos) return 0;
  const std::string_view word = line.substr(at, line.find_first_of(separators, at) - at);
  if (word == "NaN" || word == "nan" || word == "NAN") return word.size();
  const bool is_run = word.size() >= 2 && (word[0] == '-' || word[0] == '*' || word[0] == '?') &&
                      word[1] != '.' &&
                      std::ranges::all_of(word, [&](char c) { return c == word[0] || c == '.'; });
  return is_run ? word.size() : 0;
}

}  // namespace

LineCut cut_at_numbers(std::string_view line) {
  LineCut cut;
  std::size_t number_end = line.size();
  for (std::size_t i = 0; i < line.size();) {
    std::size_t size = cut.numbers.size() < most_groups ? number_at(line, i, number_end) : 0;
    if (size == 0 && cut.numbers.size() < most_groups) size = gap_at(line, i);
    if (size == 0) {
      // The digits of a name are not looked at one by one.
      do cut.texts.back() += line[i++];
      while (i < line.size() && is_digit(line[i]) && is_digit(line[i - 1]));
      continue;
    }
    std::string& before = cut.texts.back();
    const std::size_t text = before.find_last_not_of(' ') + 1;
    cut.blanks.push_back(before.size() - text);
    before.resize(text);
    cut.numbers.push_back(line.substr(i, size));
    cut.hexadecimal.push_back(is_behind_hex_prefix(line, i));
    cut.texts.emplace_back();
    i += size;
    number_end = i;
  }
  return cut;
}

}  // namespace drydock::guess
