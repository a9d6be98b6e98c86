#include "drivers/capture/formats/actisense_ascii.hpp"

#include "drivers/capture/words.hpp"
#include "drivers/wire/hex.hpp"

namespace drydock::capture {

namespace {

/// `hhmmss.ddd`
std::optional<std::chrono::nanoseconds> parse_compact_clock(std::string_view text) {
  if (text.size() < 6) return std::nullopt;
  std::string clock(text.substr(0, 2));
  clock.append(":").append(text.substr(2, 2)).append(":").append(text.substr(4));
  return parse_clock(clock);
}

std::optional<N2kMessage> parse(std::string_view line) {
  if (!line.starts_with('A')) return std::nullopt;
  Words words(line.substr(1));
  N2kMessage message;
  message.time = parse_compact_clock(words.next());
  const auto address = words.next(), group = words.next(), data = words.next();
  const auto addresses = wire::parse_hex(address), pgn = wire::parse_hex(group);
  if (!message.time || address.size() != 5 || !addresses || (*addresses & 0xF) > 7 || !pgn ||
      *pgn > 0x3FFFF || !words.next().empty() || !wire::parse_hex_bytes(data, message.data))
    return std::nullopt;
  message.id = {static_cast<std::uint8_t>(*addresses & 0xF), *pgn,
                static_cast<std::uint8_t>(*addresses >> 4),
                static_cast<std::uint8_t>(*addresses >> 12)};
  message.size = data.size() / 2;
  return message;
}

}  // namespace

bool ActisenseAscii::recognises(std::string_view line) { return parse(line).has_value(); }

Reading ActisenseAscii::read_line(std::string_view line) {
  auto message = parse(line);
  if (!message) return Reading::damage();
  message->time = clock_.since_first_midnight(*message->time);
  return frames_.first(*message, true);
}

}  // namespace drydock::capture
