#include "drivers/capture/formats/pcan_trc.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "drivers/capture/words.hpp"

namespace drydock::capture {

namespace {

using std::chrono::nanoseconds;
using wire::CanFrame;

struct Version {
  std::string_view number, columns;
};
/// Files of version 2 list their columns themselves.
constexpr std::array<Version, 4> versions{
    {{"1.0", "NOILD"}, {"1.1", "NOTILD"}, {"1.2", "NOBTILD"}, {"1.3", "NOBTIRLD"}}};

/// Days since 1899-12-30, with a fraction.
nanoseconds parse_start(std::string_view text) {
  constexpr int day_of_1970 = 25'569, day_of_2091 = 70'000;
  constexpr double ns_per_day = 86'400e9;
  const std::size_t dot = std::min(text.find('.'), text.size());
  const auto day = parse_number(text.substr(0, dot), 10);
  double fraction = 0;
  const auto decimals = text.substr(dot);
  std::from_chars(decimals.data(), decimals.data() + decimals.size(), fraction);
  if (!day || *day < day_of_1970 || *day > day_of_2091 || !(fraction >= 0 && fraction < 1)) {
    return nanoseconds{0};
  }
  return std::chrono::days{*day - day_of_1970} + nanoseconds{std::llround(fraction * ns_per_day)};
}

enum class Kind : std::uint8_t { data, remote, fd, fd_switched, error, other };

Kind kind_of(std::string_view type) {
  if (type == "Rx" || type == "Tx" || type == "DT") return Kind::data;
  if (type == "RR") return Kind::remote;
  if (type == "FD" || type == "FE") return Kind::fd;
  if (type == "FB" || type == "BI") return Kind::fd_switched;
  if (type == "ER" || type == "Error") return Kind::error;
  return Kind::other;
}

bool read_identifier(std::string_view word, CanFrame& frame) {
  const auto id = parse_number(word, 16);
  frame.extended = word.size() > 4;
  frame.id = id.value_or(0);
  return id && *id <= (frame.extended ? 0x1FFFFFFFu : 0x7FFu);
}

bool read_content(Words& words, std::uint32_t size, CanFrame& frame) {
  if (!(frame.fd ? is_fd_size(size) : size <= 8)) return false;
  if (!frame.remote && words.peek() != "RTR") return read_data(words, size, 16, frame);
  frame.remote = true;
  frame.size = static_cast<std::uint8_t>(size);
  return true;
}

/// A line that is being read: the content of its columns so far.
struct Row {
  Record record;
  Kind kind = Kind::data;
  std::uint32_t bus = 1, size = 0;
};

/// False if the word is not valid in this column.
bool read_column(char column, std::string_view word, Row& row) {
  CanFrame& frame = row.record.frame;
  const auto number = parse_number(word, 10);
  switch (column) {
    case 'O': row.record.time = parse_time(word, 6); return row.record.time.has_value();
    case 'T':
      row.kind = kind_of(word);
      frame.fd = row.kind == Kind::fd || row.kind == Kind::fd_switched;
      frame.bit_rate_switch = row.kind == Kind::fd_switched;
      frame.remote = row.kind == Kind::remote;
      return true;
    case 'B': row.bus = number.value_or(0); return row.bus > 0;
    case 'I': return read_identifier(word, frame);
    case 'l': row.size = number.value_or(0); return number.has_value();
    case 'L':
      row.size = frame.fd && number ? size_of_length_code(*number).value_or(0) : number.value_or(0);
      return number.has_value();
    default: return true;  // N, d, R
  }
}

}  // namespace

bool PcanTrc::recognises(std::string_view line) {
  if (line.starts_with(";$FILEVERSION=")) return true;
  const bool is_numbered = Words(line).peek().ends_with(')');
  return is_numbered && PcanTrc().read_line(line).record.has_value();
}

Reading PcanTrc::read_line(std::string_view line) {
  if (!line.starts_with(';')) return read_columns(line);
  read_head(line);
  return Reading::nothing();
}

void PcanTrc::read_head(std::string_view line) {
  const auto value_of = [&](std::string_view key) -> std::optional<std::string_view> {
    if (!line.starts_with(key)) return std::nullopt;
    return Words(line.substr(key.size())).peek();
  };
  if (const auto number = value_of(";$FILEVERSION=")) {
    for (const Version& version : versions) {
      if (version.number == *number) columns_ = version.columns;
    }
  }
  if (const auto days = value_of(";$STARTTIME=")) start_ = parse_start(*days);
  constexpr std::string_view start_word = "Start time: ";
  if (const auto word = line.find(start_word); word != line.npos)
    read_other_start(line.substr(word + start_word.size()));
  if (const auto letters = value_of(";$COLUMNS=")) {
    columns_ = *letters;
    std::erase(columns_, ',');
  }
}

/// The same start in words, as python-can writes it: its version 4.1 counts a log's first time from
/// now, and writes another fraction of the day. PEAK's programs write the day first.
void PcanTrc::read_other_start(std::string_view text) {
  Words words(text);
  const auto date = parse_date(words.next()), clock = parse_clock(words.next());
  const auto apart = date && clock ? start_ - (*date + *clock) : nanoseconds{0};
  if (start_ == nanoseconds{0} || std::chrono::abs(apart) <= std::chrono::seconds{1}) return;
  start_ = nanoseconds{0};
  note_ = "its head tells two different starts, so that its times count from its start";
}

Reading PcanTrc::read_columns(std::string_view line) {
  constexpr std::string_view status_identifier = "FFFFFFFF";  // versions 1.0 to 1.3
  Words words(line);
  Row row;
  for (const char column : columns_) {
    if (column == 'I' && (row.kind == Kind::other || words.peek() == status_identifier)) {
      return Reading::nothing();
    }
    if (column == 'I' && row.kind == Kind::error) {
      row.record.frame = unspecified_error();
      return on_bus(row.bus, row.record);
    }
    if (column == 'D') {
      if (!read_content(words, row.size, row.record.frame)) return Reading::damage();
      return on_bus(row.bus, row.record);
    }
    if (!read_column(column, words.next(), row)) return Reading::damage();
  }
  return Reading::damage();
}

Reading PcanTrc::on_bus(std::uint32_t bus, Record record) {
  interface_ = "can" + std::to_string(bus - 1);
  record.interface = interface_;
  if (record.time) *record.time += start_;
  return {record, false};
}

}  // namespace drydock::capture
