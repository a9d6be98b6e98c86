#include "drivers/capture/formats/canboat_plain.hpp"

#include <algorithm>

#include "drivers/capture/words.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::capture {

namespace {

/// `2022-09-28-11:36:59.668` or `2022-09-10T12:10:16.812Z`.
std::optional<std::chrono::nanoseconds> parse_stamp(std::string_view text) {
  if (text.ends_with('Z')) text.remove_suffix(1);
  if (text.size() < 19 || (text[10] != '-' && text[10] != 'T')) return std::nullopt;
  const auto date = parse_date(text.substr(0, 10));
  const auto clock = parse_clock(text.substr(11));
  if (!date || !clock) return std::nullopt;
  return *date + *clock;
}

/// Reads the next five fields. False if one is out of its range.
bool read_address(wire::TextFields& fields, wire::j1939::Identifier& id, std::size_t& size) {
  const auto within = [&](std::uint32_t largest) -> std::optional<std::uint32_t> {
    const auto number = parse_number(fields.text(), 10);
    return number && *number <= largest ? number : std::nullopt;
  };
  const auto priority = within(7), pgn = within(0x3FFFF), source = within(255);
  const auto destination = within(255), length = within(wire::j1939::transport_max_bytes);
  if (!priority || !pgn || !source || !destination || !length) return false;
  id = {static_cast<std::uint8_t>(*priority), *pgn, static_cast<std::uint8_t>(*destination),
        static_cast<std::uint8_t>(*source)};
  size = *length;
  return true;
}

/// Without what a Signal K server writes in front, its time in milliseconds and the kind of the
/// line: `1731371761185;A;`
std::string_view without_mark(std::string_view line) {
  const std::size_t digits = std::min(line.find_first_not_of("0123456789"), line.size());
  const std::string_view behind = line.substr(digits);
  const bool marked = digits >= 10 && behind.size() > 3 && behind[0] == ';' && behind[2] == ';';
  return marked ? behind.substr(3) : line;
}

std::optional<N2kMessage> parse(std::string_view line) {
  wire::TextFields fields(without_mark(line));
  N2kMessage message;
  const std::string_view stamp = fields.text();
  message.time = parse_stamp(stamp);
  if (!message.time && !stamp.empty()) return std::nullopt;
  if (!read_address(fields, message.id, message.size)) return std::nullopt;
  for (std::size_t i = 0; i < message.size; ++i) {
    const auto byte = parse_number(fields.text(), 16);
    if (!byte || *byte > 255) return std::nullopt;
    message.data.at(i) = static_cast<std::uint8_t>(*byte);
  }
  return message;
}

}  // namespace

bool CanboatPlain::recognises(std::string_view line) { return parse(line).has_value(); }

Reading CanboatPlain::read_line(std::string_view line) {
  if (line[0] == '#') return Reading::nothing();
  const auto message = parse(line);
  if (!message) return Reading::damage();
  assembled_ = assembled_ || message->size > 8;
  return frames_.first(*message, assembled_);
}

}  // namespace drydock::capture
