#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace drydock::guess {

inline constexpr std::size_t most_groups = 32;  ///< numbers of a line; a description takes no more

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
constexpr bool is_hex_digit(char c) {
  return is_digit(c) || (c >= 'A' && c <= 'F') || (c >= 'a' && c <= 'f');
}

/// The text between the numbers of a line (one more than there are numbers), and the numbers.
/// Blanks before a number are apart: many programs fill a number up to a width.
struct LineCut {
  std::vector<std::string> texts{""};
  std::vector<std::string_view> numbers;
  std::vector<std::size_t> blanks;  ///< before each number
  std::vector<bool> hexadecimal;    ///< each number; its 0x belongs to the text
};

/// What stands for a number that is not there ("NaN", "----.-") counts as one.
LineCut cut_at_numbers(std::string_view line);

}  // namespace drydock::guess
