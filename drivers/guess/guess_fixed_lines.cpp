#include <algorithm>
#include <map>

#include "drivers/guess/fixed_columns.hpp"
#include "drivers/guess/guess.hpp"
#include "drivers/guess/left_out.hpp"
#include "drivers/guess/line_cut.hpp"

/// Lines that are equally long, with each number at the same place: a strip chart's or TSS1's
/// ":9900BF -0127F 0797 -2940".
namespace drydock::guess {
namespace {

constexpr std::size_t fewest_fixed_lines = 8, longest_fixed_line = 128;

std::size_t usual_size(const std::vector<std::string_view>& lines) {
  std::map<std::size_t, std::size_t> times;
  for (const std::string_view line : lines) ++times[line.size()];
  return std::ranges::max_element(times, {}, [](const auto& one) { return one.second; })->first;
}

}  // namespace

LinesGuess guess_fixed_lines(const std::vector<std::string_view>& all) {
  if (all.size() <= fewest_fixed_lines) return {};
  std::vector<std::string_view> lines;
  LeftOut left_out;
  const std::size_t size = usual_size(all);
  for (std::size_t i = 1; i < all.size(); ++i) {  // the first may be cut
    const bool plain =
        std::ranges::all_of(all[i], [](char c) { return c >= ' ' && c <= '~' && c != '\''; });
    if (plain && all[i].size() == size)
      lines.push_back(all[i]);
    else
      left_out.add(all[i]);
  }
  if (size > longest_fixed_line || lines.size() * 20 < (all.size() - 1) * 19) return {};
  const auto text = fixed_lines_text(lines);
  if (!text) return {};
  return {
      "\n[protocol]\n# lines without a checksum, in columns of a fixed width; hex_signed is the "
      "type of a\n"
      "# hexadecimal number that can be negative\n" +
          *text + left_out.text(),
      lines.size()};
}

}  // namespace drydock::guess
