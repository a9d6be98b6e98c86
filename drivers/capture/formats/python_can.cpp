#include "drivers/capture/formats/python_can.hpp"

#include "drivers/capture/base64.hpp"
#include "drivers/capture/words.hpp"
#include "drivers/wire/hex.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::capture {

namespace {

constexpr std::string_view head = "timestamp,arbitration_id,extended,remote,error,dlc,data";
constexpr int seconds = 9;  ///< 10^9 ns

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
  if (!*remote && decode_base64(fields.text(), record.frame.data) != *size) return std::nullopt;
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
