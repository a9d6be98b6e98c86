#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/guess/line_cut.hpp"

/// Lines of one form: they differ in their numbers, and here and there in a word.
namespace drydock::guess {

/// What stood at one place of the lines.
struct Numbers {
  std::size_t count = 0;
  double low = 0, high = 0;
  std::size_t decimals = 0, digits = 0;  ///< digits: of a hexadecimal number, the most
  bool hexadecimal = false, has_plus = false, has_exponent = false;
  std::size_t fewest_blanks = most_groups, most_blanks = 0;  ///< before it
  std::set<std::string, std::less<>> gaps;                   ///< in the place of a number

  void add(std::string_view text, std::size_t blanks, bool is_hexadecimal);
  void add(const Numbers& others);
};

/// Texts that stood at one place, and how often.
using Words = std::map<std::string, std::size_t>;

struct LineForm {
  static constexpr std::size_t most_words = 8;  ///< at one place, but for the last

  std::size_t lines = 0;
  std::string example;
  std::vector<Words> texts;  ///< before each number, and behind the last
  std::vector<Numbers> columns;

  void add(std::string_view line, const LineCut& cut);
  /// Takes the lines of another form with as many numbers and the same beginning. False: their
  /// texts differ too much for one message.
  bool merge(const LineForm& other);
  bool has_numbers() const;
  /// The text that came most often.
  const std::string& usual(std::size_t place) const;
};

}  // namespace drydock::guess
