#include "drivers/wire/can/candump.hpp"

#include <algorithm>
#include <charconv>

#include "drivers/wire/can/data_length.hpp"
#include "drivers/wire/hex.hpp"

namespace drydock::wire {

namespace {

using candump::Direction;
using candump::Line;

constexpr std::uint32_t error_flag = 0x20000000;
constexpr std::uint32_t max_standard_id = 0x7FF, max_extended_id = 0x1FFFFFFF;
constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }
constexpr std::size_t longest_interface = 21;  // the limit of canplayer; Linux itself has 15

std::optional<std::uint64_t> parse_decimal(std::string_view digits) {
  std::uint64_t value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

/// `1436509052.249713`: 1 to 9 decimals, seconds up to the year 2262.
std::optional<std::chrono::nanoseconds> parse_time(std::string_view text) {
  const std::size_t dot = text.find('.');
  if (dot == std::string_view::npos) return std::nullopt;
  const std::string_view decimals = text.substr(dot + 1);
  const auto seconds = parse_decimal(text.substr(0, dot));
  auto fraction = parse_decimal(decimals);
  if (!seconds || !fraction || *seconds >= 9223372036 || decimals.size() > 9) return std::nullopt;
  for (std::size_t i = decimals.size(); i < 9; ++i) *fraction *= 10;
  return std::chrono::nanoseconds{static_cast<std::int64_t>(*seconds * 1000000000 + *fraction)};
}

/// Pairs of hex digits. There may be dots between the bytes.
std::optional<std::uint8_t> parse_data(std::string_view text, std::span<std::uint8_t> out) {
  std::size_t size = 0;
  while (!text.empty()) {
    if (size > 0 && text.front() == '.') text.remove_prefix(1);
    if (text.size() < 2 || size == out.size()) return std::nullopt;
    if (!parse_hex_bytes(text.substr(0, 2), out.subspan(size, 1))) return std::nullopt;
    ++size;
    text.remove_prefix(2);
  }
  return static_cast<std::uint8_t>(size);
}

bool parse_fd(std::string_view flags_and_data, CanFrame& frame) {
  const auto flags = parse_hex(flags_and_data.substr(0, 1));
  if (!flags) return false;
  const auto size = parse_data(flags_and_data.substr(1), frame.data);
  if (!size || !is_fd_size(*size)) return false;
  frame.fd = true;
  frame.bit_rate_switch = (*flags & 1) != 0;
  frame.size = *size;
  return true;
}

bool parse_remote(std::string_view length, CanFrame& frame) {
  frame.remote = true;
  if (length.empty()) return true;
  const auto size = parse_hex(length);
  if (!size || *size > 8) return false;
  frame.size = static_cast<std::uint8_t>(*size);
  return true;
}

/// Parses the text behind the first '#'. An `_` after 8 bytes gives a raw length code of 9..F.
bool parse_content(std::string_view text, CanFrame& frame) {
  if (!text.empty() && text[0] == '#') return parse_fd(text.substr(1), frame);
  if (!text.empty() && text[0] == 'R') return parse_remote(text.substr(1), frame);
  if (text.size() > 2 && text[text.size() - 2] == '_') text.remove_suffix(2);
  const auto size = parse_data(text, std::span{frame.data}.first(8));
  if (!size) return false;
  frame.size = *size;
  return true;
}

/// Removes the text up to `separator` from the front of `rest` and returns it.
std::optional<std::string_view> cut(std::string_view& rest, char separator) {
  const std::size_t at = rest.find(separator);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view head = rest.substr(0, at);
  rest.remove_prefix(at + 1);
  return head;
}

/// Removes the word at the front of `rest` and the blanks around it. Programs write one blank;
/// people and editors write more, or tabs.
std::string_view cut_word(std::string_view& rest) {
  const auto begin = std::find_if_not(rest.begin(), rest.end(), is_blank);
  const auto end = std::find_if(begin, rest.end(), is_blank);
  rest = {std::find_if_not(end, rest.end(), is_blank), rest.end()};
  return {begin, end};
}

std::optional<Direction> direction_of(std::string_view word) {
  if (word.empty()) return Direction::unknown;
  if (word == "R") return Direction::received;
  if (word == "T") return Direction::transmitted;
  return std::nullopt;
}

}  // namespace

bool candump::parse_identifier(std::string_view text, CanFrame& frame) {
  const auto id = parse_hex(text);
  if (!id) return false;
  frame.id = *id;
  if (text.size() == 3) return *id <= max_standard_id;
  if (text.size() != 8) return false;
  frame.error = (*id & error_flag) != 0;
  frame.extended = !frame.error;
  frame.id = *id & ~error_flag;
  return frame.id <= max_extended_id;
}

std::optional<Line> candump::parse_line(std::string_view rest) {
  if (rest.empty() || rest[0] != '(') return std::nullopt;
  rest.remove_prefix(1);
  const auto stamp = cut(rest, ')');
  if (!stamp || rest.empty() || !is_blank(rest[0])) return std::nullopt;
  Line line;
  line.interface = cut_word(rest);
  if (line.interface.empty() || line.interface.size() > longest_interface) return std::nullopt;
  std::string_view content = cut_word(rest);
  const auto direction = direction_of(cut_word(rest));
  const auto time = parse_time(*stamp);
  const auto id = cut(content, '#');
  if (!time || !id || !direction || !rest.empty() || !parse_identifier(*id, line.frame) ||
      !parse_content(content, line.frame)) {
    return std::nullopt;
  }
  line.time = *time;
  line.direction = *direction;
  return line;
}

}  // namespace drydock::wire

namespace drydock::wire::candump {

namespace {

void put_content(TextWriter& text, const CanFrame& frame) {
  if (frame.fd) {
    text.put('#');
    text.put_hex(frame.bit_rate_switch ? 5 : 4, 1);  // 4 means CAN FD, 1 faster data phase
  }
  if (frame.remote) {
    text.put('R');
    if (frame.size > 0) text.put_hex(frame.size, 1);
    return;
  }
  text.put_hex_bytes(frame.payload());
}

}  // namespace

std::size_t encode(const Line& line, std::span<std::uint8_t> out) {
  const auto us = static_cast<std::uint64_t>(line.time.count()) / 1000;
  TextWriter text(out);
  text.put('(');
  text.put_decimal(us / 1000000, 10);
  text.put('.');
  text.put_decimal(us % 1000000, 6);
  text.put(") ");
  text.put(line.interface);
  text.put(' ');
  const CanFrame& frame = line.frame;
  text.put_hex(frame.error ? frame.id | error_flag : frame.id,
               frame.extended || frame.error ? 8 : 3);
  text.put('#');
  put_content(text, frame);
  if (line.direction == Direction::received) text.put(" R");
  if (line.direction == Direction::transmitted) text.put(" T");
  text.put('\n');
  return text.size();
}

}  // namespace drydock::wire::candump
