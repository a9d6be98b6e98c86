#include "drivers/capture/formats/canboat_plain.hpp"

#include <algorithm>

#include "drivers/capture/words.hpp"
#include "drivers/wire/nmea2000/fast_packet.hpp"
#include "drivers/wire/nmea2000/fast_pgns.hpp"
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
  const auto destination = within(255), length = within(wire::fast_packet_max_bytes);
  if (!priority || !pgn || !source || !destination || !length) return false;
  id = {static_cast<std::uint8_t>(*priority), *pgn, static_cast<std::uint8_t>(*destination),
        static_cast<std::uint8_t>(*source)};
  size = *length;
  return true;
}

}  // namespace

bool CanboatPlain::recognises(std::string_view line) {
  return CanboatPlain().parse(line).has_value();
}

Reading CanboatPlain::read_line(std::string_view line) {
  return line[0] == '#' ? Reading::nothing() : Reading::of(parse(line));
}

std::optional<Record> CanboatPlain::parse(std::string_view line) {
  wire::TextFields fields(line);
  time_ = parse_stamp(fields.text());
  if (!time_ || !read_address(fields, id_, size_)) return std::nullopt;
  for (std::size_t i = 0; i < size_; ++i) {
    const auto byte = parse_number(fields.text(), 16);
    if (!byte || *byte > 255) return std::nullopt;
    message_[i] = static_cast<std::uint8_t>(*byte);
  }
  assembled_ = assembled_ || size_ > 8;
  is_fast_ = size_ > 8 || (assembled_ && wire::is_fast_pgn(id_.pgn));
  frames_given_ = 0;
  sequence_ = (sequence_ + 1) % 8;
  return next_frame();
}

std::optional<Record> CanboatPlain::more() {
  return is_fast_ && frames_given_ < wire::fast_packet_frames(size_) ? next_frame() : std::nullopt;
}

std::optional<Record> CanboatPlain::next_frame() {
  Record record{time_, "can0", {}};
  const wire::Bytes message{message_.data(), size_};
  if (is_fast_) {
    record.frame = wire::encode_fast_packet(id_, sequence_, message, frames_given_);
  } else {
    record.frame.id = wire::j1939::make_identifier(id_);
    record.frame.extended = true;
    record.frame.size = static_cast<std::uint8_t>(size_);
    std::copy(message.begin(), message.end(), record.frame.data.begin());
  }
  ++frames_given_;
  return record;
}

}  // namespace drydock::capture
