#include "drivers/capture/formats/busmaster.hpp"

#include <algorithm>
#include <array>

#include "drivers/capture/words.hpp"

namespace drydock::capture {

namespace {

using std::chrono::nanoseconds;

constexpr std::string_view mark = "***", start_word = "***START DATE AND TIME ";

/// `22:20:15:2`. Empty if it is none.
std::optional<nanoseconds> parse_stamp(std::string_view text) {
  std::array<std::uint32_t, 4> parts{};
  std::size_t last_digits = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t end = std::min(text.find(':'), text.size());
    const auto number = parse_number(text.substr(0, end), 10);
    if (!number || (end == text.size()) != (i == 3)) return std::nullopt;
    parts.at(i) = *number;
    last_digits = end;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  constexpr std::uint32_t longest_h = 1'000'000;  // since the start of a log
  if (parts[0] > longest_h || parts[1] > 59 || parts[2] > 59 || last_digits > 4)
    return std::nullopt;
  const nanoseconds tick =
      last_digits == 4 ? std::chrono::microseconds{100} : nanoseconds{1'000'000};
  return std::chrono::hours{parts[0]} + std::chrono::minutes{parts[1]} +
         std::chrono::seconds{parts[2]} + parts[3] * tick;
}

/// `23:9:2015`.
std::optional<nanoseconds> parse_day(std::string_view text) {
  const std::size_t first = text.find(':'), second = text.find(':', first + 1);
  if (first == text.npos || second == text.npos) return std::nullopt;
  const auto day = parse_number(text.substr(0, first), 10);
  const auto month = parse_number(text.substr(first + 1, second - first - 1), 10);
  const auto year = parse_number(text.substr(second + 1), 10);
  if (!day || !month || !year) return std::nullopt;
  return date_time(static_cast<int>(*year), *month, *day);
}

bool read_identifier(std::string_view word, int base, std::string_view type,
                     wire::CanFrame& frame) {
  if (word.starts_with("0x")) {
    word.remove_prefix(2);
    base = 16;
  }
  const auto id = parse_number(word, base);
  frame.extended = type == "x" || type == "xr";
  frame.remote = type == "sr" || type == "xr";
  frame.id = id.value_or(0);
  const bool known = frame.extended || frame.remote || type == "s";
  return known && id && *id <= (frame.extended ? 0x1FFFFFFFu : 0x7FFu);
}

struct Line {
  nanoseconds told{};
  std::uint32_t channel = 0;
  wire::CanFrame frame;
};

std::optional<Line> parse(std::string_view text, int base) {
  Words words(text);
  Line line;
  const auto told = parse_stamp(words.next());
  const auto direction = words.next();
  const auto channel = parse_number(words.next(), 10);
  const auto id = words.next(), type = words.next();
  const auto size = parse_number(words.next(), 10);
  if (!told || (direction != "Rx" && direction != "Tx") || !channel || !size || *size > 8 ||
      !read_identifier(id, base, type, line.frame))
    return std::nullopt;
  line.told = *told;
  line.channel = *channel;
  line.frame.size = static_cast<std::uint8_t>(*size);
  if (!line.frame.remote && !read_data(words, *size, base, line.frame)) return std::nullopt;
  return words.next().empty() || line.frame.remote ? std::optional(line) : std::nullopt;
}

}  // namespace

bool Busmaster::recognises(std::string_view line) {
  return line.starts_with("***BUSMASTER") || parse(line, 16);
}

void Busmaster::read_head(std::string_view line) {
  if (line == "***DEC***") base_ = 10;
  if (line == "***HEX***") base_ = 16;
  if (line == "***SYSTEM MODE***") times_ = Times::of_day;
  if (line == "***ABSOLUTE MODE***") times_ = Times::from_start;
  if (line == "***RELATIVE MODE***") times_ = Times::from_last;
  if (!line.starts_with(start_word) || !line.ends_with(mark)) return;
  Words words(line.substr(start_word.size(), line.size() - start_word.size() - mark.size()));
  const auto day = parse_day(words.next()), of_day = parse_stamp(words.next());
  if (!day || !of_day) return;
  date_ = *day;
  start_ = last_ = *of_day;
  clock_ = {};
  clock_.since_first_midnight(start_);
}

nanoseconds Busmaster::since_1970(nanoseconds told) {
  if (times_ == Times::of_day) return date_ + clock_.since_first_midnight(told);
  last_ = std::min((times_ == Times::from_start ? start_ : last_) + told, latest_time);
  return date_ + last_;
}

Reading Busmaster::read_line(std::string_view text) {
  if (text.starts_with(mark)) {
    read_head(text);
    return Reading::nothing();
  }
  const auto line = parse(text, base_);
  if (!line) return Reading::damage();
  interface_ = "can" + std::to_string(std::max(line->channel, 1u) - 1);
  return {Record{since_1970(line->told), interface_, line->frame}, false};
}

}  // namespace drydock::capture
