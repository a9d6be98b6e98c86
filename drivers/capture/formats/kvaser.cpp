#include "drivers/capture/formats/kvaser.hpp"

#include <algorithm>
#include <array>

#include "drivers/capture/table_row.hpp"
#include "drivers/capture/words.hpp"

namespace drydock::capture {

namespace {

using std::chrono::nanoseconds;

constexpr std::string_view title = "CSV CAN data", data_base = "Format of data field",
                           id_base = "Format of id field", pgn_base = "Format of PGN field",
                           start_word = "Logging started at";
constexpr std::array<std::string_view, 3> other_words{"Converted from", "Timestamp Offset", "#"};
constexpr std::size_t fixed_columns = 5;  // time, channel, identifier, flags, length

enum Flag : std::uint32_t {
  remote = 0x1,
  extended = 0x4,
  error = 0x20,
  fd = 0x1'0000,
  switched = 0x2'0000
};

/// 16, 10, or 0: the line says neither.
int base_in(std::string_view line) {
  return line.ends_with("HEX") ? 16 : line.ends_with("DEC") ? 10 : 0;
}

/// `2023-11-14 22:13:20`; zero: no date.
nanoseconds parse_date_and_clock(std::string_view text) {
  Words words(text);
  const auto date = parse_date(words.next()), clock = parse_clock(words.next());
  return date && clock ? *date + *clock : nanoseconds{0};
}

/// A comma may be the decimal mark where a semicolon separates.
std::optional<nanoseconds> parse_seconds(std::string_view text) {
  std::array<char, 24> figures{};
  if (text.size() > figures.size()) return std::nullopt;
  std::ranges::replace_copy(text, figures.begin(), ',', '.');
  return parse_time({figures.data(), text.size()}, 9);
}

bool is_columns(std::string_view line) {
  return line.size() > 12 && line.starts_with("Time") && line.substr(5).starts_with("Channel");
}

}  // namespace

bool Kvaser::recognises(std::string_view line) { return line == title || is_columns(line); }

void Kvaser::read_columns(std::string_view line) {
  separator_ = line[4];
  data_columns_ = 0;
  for (const auto column : row_of(line, separator_)) data_columns_ += column.starts_with("Data");
  if (!has_pgns_ && (id_base_ == 0 || data_base_ == 0))
    note_ = "its head does not say whether identifiers and data are decimal or hexadecimal";
}

/// True for a line of the head.
bool Kvaser::read_head(std::string_view line) {
  if (is_columns(line)) {
    read_columns(line);
    return true;
  }
  if (line.starts_with(data_base)) data_base_ = base_in(line);
  if (line.starts_with(id_base)) id_base_ = base_in(line);
  if (line.starts_with(pgn_base)) {
    has_pgns_ = true;
    note_ = "its identifiers are PGNs alone: convert the log without the layer of J1939";
  }
  if (line.starts_with(start_word)) {
    began_ = parse_date_and_clock(line.substr(std::min(start_word.size() + 1, line.size())));
    first_.reset();
    if (began_ != nanoseconds{0} && note_.empty())
      note_ = "its times count from the begin of the log, which it tells in whole seconds";
  }
  return line == title || line.starts_with(data_base) || line.starts_with(id_base) ||
         line.starts_with(pgn_base) || line.starts_with(start_word) ||
         std::ranges::any_of(other_words,
                             [&](std::string_view word) { return line.starts_with(word); });
}

Reading Kvaser::read_line(std::string_view line) {
  if (read_head(line)) return Reading::nothing();
  const bool known = data_columns_ > 0 && id_base_ > 0 && data_base_ > 0;
  return Reading::of(known ? frame_of(line) : std::nullopt);
}

nanoseconds Kvaser::since_1970(nanoseconds told) {
  if (!first_) first_ = told;
  return began_ == nanoseconds{0} ? told : began_ + std::max(told - *first_, nanoseconds{0});
}

std::optional<Record> Kvaser::frame_of(std::string_view line) {
  const TableRow row = row_of(line, separator_);
  if (row.size() < fixed_columns) return std::nullopt;
  const auto told = parse_seconds(row[0]);
  const auto channel = parse_number(row[1], 10), flags = parse_number(row[3], 10);
  if (!told || !channel || *channel == 0 || !flags) return std::nullopt;
  interface_ = "can" + std::to_string(*channel - 1);
  Record record{since_1970(*told), interface_, {}};
  auto& frame = record.frame;
  if ((*flags & error) != 0) {
    frame = unspecified_error();
    return record;
  }
  const auto id = parse_number(row[2], id_base_), code = parse_number(row[4], 10);
  frame.extended = (*flags & extended) != 0;
  if (!id || !code || *id > (frame.extended ? 0x1FFFFFFFu : 0x7FFu)) return std::nullopt;
  frame.id = *id;
  frame.fd = (*flags & fd) != 0;
  frame.bit_rate_switch = frame.fd && (*flags & switched) != 0;
  frame.remote = (*flags & remote) != 0;
  const auto size = frame.fd ? size_of_length_code(*code).value_or(0) : std::min(*code, 8u);
  if (*code > 15 || (!frame.remote && (size > data_columns_ || row.size() < fixed_columns + size)))
    return std::nullopt;
  frame.size = static_cast<std::uint8_t>(size);
  for (std::size_t i = 0; !frame.remote && i < size; ++i) {
    const auto byte = parse_number(row[fixed_columns + i], data_base_);
    if (!byte || *byte > 255) return std::nullopt;
    frame.data.at(i) = static_cast<std::uint8_t>(*byte);
  }
  return record;
}

}  // namespace drydock::capture
