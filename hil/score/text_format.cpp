#include "hil/score/text_format.hpp"

#include "hil/score/csv_cells.hpp"
#include "hil/score/numbers.hpp"
#include "hil/score/read_estimates.hpp"
#include "hil/score/words_of.hpp"

namespace drydock::score {
namespace {

std::string format_of_line(std::string_view line) {
  if (line.substr(line.find_first_not_of(" \t")).starts_with('<')) return "gpx";
  const auto words = words_of(line);
  const bool are_numbers = std::ranges::all_of(
      words, [](const std::string& word) { return number_of(word).has_value(); });
  if (are_numbers && words.size() == 8) return "tum";
  if (are_numbers && words.size() == kitti_numbers) return "kitti";
  return "csv";
}

}  // namespace

std::string format_of_text(std::istream& in) {
  std::string format = "csv";
  for (std::string line; std::getline(in, line);) {
    const std::string_view text = without_byte_order_mark(line);
    if (text.find_first_not_of(" \t\r") == std::string_view::npos || text.starts_with('#'))
      continue;
    format = format_of_line(text);
    break;
  }
  in.clear();
  in.seekg(0);
  return format;
}

}  // namespace drydock::score
