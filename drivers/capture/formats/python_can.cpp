#include "drivers/capture/formats/python_can.hpp"

#include "drivers/capture/words.hpp"
#include "drivers/wire/hex.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::capture {

namespace {

constexpr std::string_view head = "timestamp,arbitration_id,extended,remote,error,dlc,data";
constexpr int seconds = 9;  ///< 10^9 ns

/// RFC 4648, section 4. False if it is not of that alphabet, or has another number of bytes.
bool read_base64(std::string_view text, std::size_t bytes, wire::CanFrame& frame) {
  constexpr std::string_view alphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto digits = text.substr(0, text.find('='));
  if (text.size() % 4 != 0 || text.size() - digits.size() > 2 || digits.size() * 6 / 8 != bytes)
    return false;
  std::uint32_t bits = 0;
  for (std::size_t i = 0, at = 0; i < digits.size(); ++i) {
    const auto value = alphabet.find(digits[i]);
    if (value == alphabet.npos) return false;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    if (i % 4 != 0) frame.data.at(at++) = static_cast<std::uint8_t>(bits >> (6 - 2 * (i % 4)));
  }
  frame.size = static_cast<std::uint8_t>(bytes);
  return true;
}

/// `0` or `1`
std::optional<bool> flag(std::string_view word) {
  if (word != "0" && word != "1") return std::nullopt;
  return word == "1";
}

std::optional<Record> parse(std::string_view line) {
  wire::TextFields fields(line);
  Record record{parse_time(fields.text(), seconds), "can0", {}};
  const auto identifier = fields.text();
  if (!record.time || !identifier.starts_with("0x")) return std::nullopt;
  const auto id = wire::parse_hex(identifier.substr(2));
  const auto extended = flag(fields.text()), remote = flag(fields.text()),
             error = flag(fields.text());
  const auto size = parse_number(fields.text(), 10);
  if (!id || !extended || !remote || !error || !size || !(*size <= 8 || is_fd_size(*size)))
    return std::nullopt;
  if (*error) {
    record.frame = unspecified_error();
    return record;
  }
  if (*id > (*extended ? 0x1FFFFFFFU : 0x7FFU) || (*remote && *size > 8)) return std::nullopt;
  record.frame.id = *id;
  record.frame.extended = *extended;
  record.frame.remote = *remote;
  record.frame.fd = *size > 8;
  record.frame.size = static_cast<std::uint8_t>(*size);
  if (!*remote && !read_base64(fields.text(), *size, record.frame)) return std::nullopt;
  return record;
}

}  // namespace

bool PythonCan::recognises(std::string_view line) {
  return line == head || parse(line).has_value();
}

Reading PythonCan::read_line(std::string_view line) {
  return line == head ? Reading::nothing() : Reading::of(parse(line));
}

}  // namespace drydock::capture
