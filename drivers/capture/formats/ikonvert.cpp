#include "drivers/capture/formats/ikonvert.hpp"

#include "drivers/capture/base64.hpp"
#include "drivers/capture/words.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::capture {

namespace {

constexpr std::string_view received = "!PDGY,", told = "$PDGY,";

std::optional<std::uint32_t> number(wire::TextFields& fields, std::uint32_t largest) {
  const auto value = parse_number(fields.text(), 10);
  return value && *value <= largest ? value : std::nullopt;
}

std::optional<N2kMessage> parse(std::string_view line) {
  if (!line.starts_with(received)) return std::nullopt;
  wire::TextFields fields(line.substr(received.size()));
  const auto pgn = number(fields, 0x3FFFF), priority = number(fields, 7);
  const auto source = number(fields, 255), destination = number(fields, 255);
  N2kMessage message;
  message.time = parse_time(fields.text(), 9);
  const auto size = decode_base64(fields.text(), message.data);
  if (!pgn || !priority || !source || !destination || !message.time || !size ||
      fields.remaining() != 0)
    return std::nullopt;
  message.id = {static_cast<std::uint8_t>(*priority), *pgn, static_cast<std::uint8_t>(*destination),
                static_cast<std::uint8_t>(*source)};
  message.size = *size;
  return message;
}

/// `!PDGY,<pgn>,<destination>,<data>`
bool is_order(std::string_view line) {
  if (!line.starts_with(received)) return false;
  wire::TextFields fields(line.substr(received.size()));
  return fields.remaining() == 3 && number(fields, 0x3FFFF) && number(fields, 255);
}

}  // namespace

bool Ikonvert::recognises(std::string_view line) { return parse(line).has_value(); }

Reading Ikonvert::read_line(std::string_view line) {
  if (line.starts_with(told) || is_order(line)) return Reading::nothing();
  const auto message = parse(line);
  if (!message) return Reading::damage();
  return frames_.first(*message, true);
}

}  // namespace drydock::capture
