#include "drivers/guess/decimal_commas.hpp"

#include <algorithm>

#include "drivers/guess/line_cut.hpp"

namespace drydock::guess {
namespace {

/// What the commas and the numbers of a line are like.
struct Commas {
  std::size_t between_digits = 0, numbers = 0;
  bool others = false;  ///< a comma elsewhere, two in one number, or a point in one
};

Commas commas_of(std::string_view line) {
  Commas found;
  std::size_t of_number = 0;  ///< commas of the number that is read
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool inside =
        i > 0 && is_digit(line[i - 1]) && i + 1 < line.size() && is_digit(line[i + 1]);
    if (is_digit(line[i])) {
      const bool begins = i == 0 || (!is_digit(line[i - 1]) && of_number == 0);
      found.numbers += begins;
    } else if (line[i] == ',' && inside) {
      ++found.between_digits;
      found.others |= ++of_number > 1;
    } else {
      found.others |= line[i] == ',' || (line[i] == '.' && inside);
      of_number = 0;
    }
  }
  return found;
}

}  // namespace

bool have_decimal_commas(const std::vector<std::string_view>& lines) {
  std::size_t commas = 0, most_numbers = 0;
  for (const std::string_view line : lines) {
    const Commas of_line = commas_of(line);
    if (of_line.others) return false;
    commas += of_line.between_digits;
    most_numbers = std::max(most_numbers, of_line.numbers);
  }
  return most_numbers > 1 && commas >= lines.size();
}

std::string with_points(std::string_view line) {
  std::string copy(line);
  std::ranges::replace(copy, ',', '.');
  return copy;
}

}  // namespace drydock::guess
