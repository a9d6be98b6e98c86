#include "drivers/capture/formats/candump_screen.hpp"

#include <map>

#include "drivers/capture/words.hpp"
#include "drivers/wire/can/candump.hpp"

namespace drydock::capture {

namespace {

using wire::CanFrame;

/// `1436509052.249713)`, or `2015-07-10 08:17:32.249713)`, where a blank follows the date.
std::optional<std::chrono::nanoseconds> read_time(std::string_view first, Words& words) {
  if (first.ends_with(')')) return parse_time(first.substr(0, first.size() - 1), 9);
  const auto date = parse_date(first);
  std::string_view clock = words.next();
  if (!date || !clock.ends_with(')')) return std::nullopt;
  clock.remove_suffix(1);
  const auto since_midnight = parse_clock(clock);
  if (!since_midnight) return std::nullopt;
  return *date + *since_midnight;
}

/// `RX - -`: the direction, B for the faster data phase, E for the sender's error state.
void read_flags(Words& words, CanFrame& frame) {
  if (words.peek() != "RX" && words.peek() != "TX") return;
  words.next();
  frame.bit_rate_switch = words.next() == "B";
  words.next();
}

/// `<0x18eeff01>`: the identifier has 29 bits if the value needs more than 11.
bool read_angled_identifier(std::string_view word, CanFrame& frame) {
  if (!word.starts_with("<0x") || !word.ends_with('>')) return false;
  const auto id = parse_number(word.substr(3, word.size() - 4), 16);
  if (!id || *id > 0x1FFFFFFF) return false;
  frame.id = *id;
  frame.extended = *id > 0x7FF;
  return true;
}

/// `[8]  11 22 ...`, `[12]  11 22 ...`, `[4]  remote request`.
bool read_content(Words& words, CanFrame& frame) {
  const std::string_view length = words.next();
  if (length.size() < 3 || length.front() != '[' || length.back() != ']') return false;
  const auto size = parse_number(length.substr(1, length.size() - 2), 10);
  frame.fd = length.size() == 4;
  if (!size || !(frame.fd ? is_fd_size(*size) : *size <= 8)) return false;
  if (words.peek() != "remote") return read_data(words, *size, 16, frame);
  frame.remote = true;
  frame.size = static_cast<std::uint8_t>(*size);
  return true;
}

std::optional<Record> parse(std::string_view line, std::string_view head_interface) {
  Words words(line);
  Record record;
  std::string_view word = words.next();
  if (word.starts_with('(')) {
    record.time = read_time(word.substr(1), words);
    if (!record.time) return std::nullopt;
    word = words.next();
  }
  bool identified = read_angled_identifier(word, record.frame);
  record.interface = identified ? head_interface : word;
  if (!identified) {
    read_flags(words, record.frame);
    identified = wire::candump::parse_identifier(words.next(), record.frame);
  }
  if (!identified || !read_content(words, record.frame)) return std::nullopt;
  return record;
}

/// Empty: more lines must come. On one interface times of arrival never go back, nor are all but
/// the first the same.
std::optional<CandumpTimes> times_in(Bytes bytes, bool at_end) {
  constexpr std::size_t enough = 300, few = 8, longest_head = 64 * 1024;
  constexpr std::chrono::hours since_start{24 * 365};
  const bool whole = at_end || bytes.size() >= longest_head;
  std::map<std::string, std::chrono::nanoseconds, std::less<>> last;
  std::optional<std::chrono::nanoseconds> usual;
  std::size_t timed = 0;
  bool alike = true;
  while (!bytes.empty() && timed < enough) {
    const Scan line = scan_line(bytes, at_end);
    if (line.kind == Scan::Kind::need_more) break;
    const auto record = parse(text_of(bytes.first(line.size)), "can");
    bytes = bytes.subspan(line.size);
    if (!record) continue;
    if (!record->time || *record->time > since_start) return CandumpTimes::dates;
    const auto [before, is_new] = last.try_emplace(std::string(record->interface), *record->time);
    if (*record->time < before->second) return CandumpTimes::pauses;
    before->second = *record->time;
    if (++timed > 1) alike = alike && *record->time == *(usual = usual.value_or(*record->time));
  }
  if (!whole && timed < enough) return {};
  if (timed == 0) return CandumpTimes::dates;
  const bool all_alike = alike && timed > few && usual->count() > 0;
  return all_alike ? CandumpTimes::pauses : CandumpTimes::since_start;
}

}  // namespace

Scan CandumpScreen::scan(Bytes bytes, bool at_end) {
  if (!times_) times_ = times_in(bytes, at_end);
  return times_ ? LineReader::scan(bytes, at_end) : Scan::need_more();
}

void CandumpScreen::settle(Bytes rest) {
  if (!times_) times_ = times_in(rest, true);
}

std::string_view CandumpScreen::note() const {
  switch (times_.value_or(CandumpTimes::dates)) {
    case CandumpTimes::pauses:
      return "its times are the pauses between frames (candump -t d), summed up here";
    case CandumpTimes::since_start: return "its times count from its start (candump -t z)";
    case CandumpTimes::dates: break;
  }
  return {};
}

bool CandumpScreen::recognises(std::string_view line) { return parse(line, {}).has_value(); }

Reading CandumpScreen::read_line(std::string_view line) {
  constexpr std::string_view head = "interface = ";
  if (line.starts_with(head)) {
    interface_ = line.substr(head.size(), line.find(',') - head.size());
    return Reading::nothing();
  }
  if (line[0] == '#') return Reading::nothing();
  auto record = parse(line, interface_);
  if (record && record->time && times_ == CandumpTimes::pauses)
    record->time = sum_ += *record->time;
  return Reading::of(record);
}

}  // namespace drydock::capture
