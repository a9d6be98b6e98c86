#include <algorithm>
#include <vector>

#include "drivers/guess/guess.hpp"
#include "drivers/guess/guess_sentences.hpp"
#include "drivers/wire/described/checksums.hpp"
#include "drivers/wire/hex.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::guess {
namespace {

using wire::described::Checksum;

std::vector<std::string_view> lines_of(wire::Bytes capture) {
  std::vector<std::string_view> lines;
  std::string_view text = wire::as_text(capture);
  while (!text.empty()) {
    const std::size_t end = text.find_first_of("\r\n");
    if (end > 0 && end != text.npos) lines.push_back(text.substr(0, end));
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
  }
  return lines;
}

LineSum line_checksum(const std::vector<std::string_view>& lines) {
  for (const std::string_view name :
       {"xor", "sum-8", "crc-8/smbus", "crc-8/maxim-dow", "crc-16/xmodem", "crc-16/ibm-3740",
        "crc-16/modbus", "crc-16/kermit", "crc-32/iso-hdlc", "crc-32/novatel"}) {
    Checksum checksum;
    Checksum::find(name, checksum);
    for (const std::size_t from : {std::size_t{1}, std::size_t{0}}) {
      const auto right = std::ranges::count_if(lines, [&](std::string_view line) {
        const std::size_t star = line.rfind('*');
        if (star == line.npos || star + 1 + 2 * checksum.size() != line.size() || star <= from)
          return false;
        const auto* begin = reinterpret_cast<const std::uint8_t*>(line.data());
        return wire::parse_hex(line.substr(star + 1)) == checksum.of({begin + from, star - from});
      });
      if (2 * static_cast<std::size_t>(right) > lines.size()) return {name, from};
    }
  }
  return {};
}

}  // namespace

std::string guess_text(wire::Bytes capture) {
  const auto lines = lines_of(capture);
  constexpr std::size_t fewest = 2;
  if (lines.size() < fewest) return {};
  const LineSum sum = line_checksum(lines);
  const auto sentences = std::ranges::count_if(
      lines, [](std::string_view line) { return line[0] == '$' || line[0] == '!'; });
  const bool without = 2 * static_cast<std::size_t>(sentences) > lines.size();
  if (sum.checksum != "none" || without) return guess_sentences(lines, sum);
  auto hex = guess_hex_lines(lines);
  if (!hex.empty()) return hex;
  const LinesGuess by_numbers = guess_lines(lines);
  if (by_numbers.lines * 10 > lines.size() * 9) return by_numbers.text;
  const LinesGuess by_places = guess_fixed_lines(lines);
  return by_places.lines > by_numbers.lines ? by_places.text : by_numbers.text;
}

}  // namespace drydock::guess
