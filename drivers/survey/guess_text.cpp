#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "drivers/survey/guess.hpp"
#include "drivers/wire/described/checksums.hpp"
#include "drivers/wire/hex.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::survey {
namespace {

using wire::described::Checksum;

/// What one column of a kind of sentence held.
struct Column {
  std::set<std::string, std::less<>> words;  ///< the first few that differ
  double low = 0, high = 0;
  std::size_t numbers = 0, empty = 0, rows = 0;

  void add(std::string_view word) {
    constexpr std::size_t few = 4;
    ++rows;
    if (words.size() < few) words.emplace(word);
    empty += word.empty();
    const auto number = wire::parse_number(word);
    if (!number) return;
    low = numbers == 0 ? *number : std::min(low, *number);
    high = numbers == 0 ? *number : std::max(high, *number);
    ++numbers;
  }
};

struct Sentence {
  std::map<std::size_t, std::vector<Column>> by_count;  ///< fields -> columns
  std::size_t rows = 0;
};

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

/// A checksum behind the '*' that is right in nearly all lines, and its first byte.
struct Guess {
  std::string_view checksum = "none";
  std::size_t from = 0;
};

Guess line_checksum(const std::vector<std::string_view>& lines) {
  for (const std::string_view name : {"xor", "sum-8", "crc-8/smbus", "crc-8/maxim-dow"}) {
    Checksum checksum;
    Checksum::find(name, checksum);
    for (const std::size_t from : {std::size_t{1}, std::size_t{0}}) {
      const auto right = std::ranges::count_if(lines, [&](std::string_view line) {
        const std::size_t star = line.rfind('*');
        if (star == line.npos || star + 3 != line.size() || star <= from) return false;
        const auto* begin = reinterpret_cast<const std::uint8_t*>(line.data());
        return wire::parse_hex(line.substr(star + 1)) == checksum.of({begin + from, star - from});
      });
      if (2 * static_cast<std::size_t>(right) > lines.size()) return {name, from};
    }
  }
  return {};
}

std::string column_text(const Column& column, std::size_t i) {
  const std::string name = fmt::format("column_{}", i + 1);
  const bool numbers = column.numbers > 0 && column.numbers + column.empty == column.rows;
  if (numbers)
    return fmt::format("  {{ name = \"{}\" }},  # {} to {}{}", name, column.low, column.high,
                       column.empty > 0 ? ", sometimes empty" : "");
  const bool plain = std::ranges::all_of(column.words, [](const std::string& word) {
    return word.find_first_of("\"\\") == word.npos;
  });
  if (column.words.size() == 1 && plain)
    return fmt::format("  {{ text = \"{}\" }},", *column.words.begin());
  return fmt::format("  {{ name = \"{}\", type = \"text\" }},", name);
}

std::string sentences_text(const std::vector<std::string_view>& lines, const Guess& guess) {
  std::map<std::string, Sentence, std::less<>> sentences;
  for (std::string_view line : lines) {
    line = line.substr(0, line.rfind('*'));
    wire::TextFields fields(line);
    const std::string id(fields.text());
    if (id.size() < 2 || id.size() > 16) continue;
    auto& columns = sentences[id].by_count[fields.remaining()];
    columns.resize(fields.remaining());
    ++sentences[id].rows;
    for (auto& column : columns) column.add(fields.text());
  }
  std::string out = fmt::format("\n[protocol]\nchecksum = \"{}\"\n", guess.checksum);
  if (guess.from == 0) out += "checksum_from = 0\n";
  for (const auto& [id, sentence] : sentences) {
    std::size_t form = 0;
    for (const auto& [count, columns] : sentence.by_count) {
      out += fmt::format("\n[[protocol.sentences]]          # {} times\nid = \"{}\"\n",
                         columns.empty() ? sentence.rows : columns[0].rows, id);
      if (form++ > 0) out += fmt::format("name = \"form_{}_of_{}\"\n", form, sentences.size());
      out += "fields = [\n";
      for (std::size_t i = 0; i < columns.size(); ++i) out += column_text(columns[i], i) + "\n";
      out += "]\n";
    }
  }
  return out;
}

}  // namespace

std::string guess_text(wire::Bytes capture) {
  const auto lines = lines_of(capture);
  constexpr std::size_t fewest = 2;
  if (lines.size() < fewest) return {};
  const Guess guess = line_checksum(lines);
  const auto sentences = std::ranges::count_if(
      lines, [](std::string_view line) { return line[0] == '$' || line[0] == '!'; });
  const bool without = 2 * static_cast<std::size_t>(sentences) > lines.size();
  if (guess.checksum != "none" || without) return sentences_text(lines, guess);
  return guess_lines(lines);
}

}  // namespace drydock::survey
