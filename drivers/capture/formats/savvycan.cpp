#include "drivers/capture/formats/savvycan.hpp"

#include "drivers/capture/words.hpp"
#include "drivers/wire/hex.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::capture {

namespace {

constexpr int microseconds = 3;  ///< 10^3 ns

std::optional<bool> truth_of(std::string_view word) {
  if (word == "true") return true;
  if (word == "false") return false;
  return std::nullopt;
}

bool is_head(std::string_view line) { return line.starts_with("Time Stamp,ID,Extended,"); }

}  // namespace

bool SavvyCan::recognises(std::string_view line) {
  return is_head(line) || SavvyCan().parse(line).has_value();
}

Reading SavvyCan::read_line(std::string_view line) {
  return is_head(line) ? Reading::nothing() : Reading::of(parse(line));
}

std::optional<Record> SavvyCan::parse(std::string_view line) {
  wire::TextFields fields(line);
  Record record;
  record.time = parse_time(fields.text(), microseconds);
  auto digits = fields.text();
  if (digits.starts_with("0x")) digits.remove_prefix(2);
  const auto id = wire::parse_hex(digits);
  const auto extended = truth_of(fields.text());
  auto bus = fields.text();
  if (bus == "Rx" || bus == "Tx") bus = fields.text();
  const auto number = parse_number(bus, 10), size = parse_number(fields.text(), 10);
  if (!record.time || !id || !extended || *id > (*extended ? 0x1FFFFFFFU : 0x7FFU) || !number ||
      *number > 99 || !size || !(*size <= 8 || is_fd_size(*size)))
    return std::nullopt;
  record.frame.id = *id;
  record.frame.extended = *extended;
  record.frame.fd = *size > 8;
  record.frame.size = static_cast<std::uint8_t>(*size);
  for (std::size_t i = 0; i < *size; ++i) {
    const auto byte = parse_number(fields.text(), 16);
    if (!byte || *byte > 255) return std::nullopt;
    record.frame.data.at(i) = static_cast<std::uint8_t>(*byte);
  }
  interface_ = "can" + std::to_string(*number);
  record.interface = interface_;
  return record;
}

}  // namespace drydock::capture
