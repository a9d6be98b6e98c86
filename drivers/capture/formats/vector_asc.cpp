#include "drivers/capture/formats/vector_asc.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace drydock::capture {

namespace {

using std::chrono::nanoseconds;
using wire::CanFrame;

/// English month names, and those German names that differ.
std::optional<unsigned> month_of(std::string_view word) {
  constexpr std::array<std::string_view, 16> names{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                   "Jul", "Aug", "Sep", "Oct", "Nov", "Dec",
                                                   "Mrz", "Mai", "Okt", "Dez"};
  constexpr std::array<unsigned, 4> german{3, 5, 10, 12};
  const auto found = std::find(names.begin(), names.end(), word.substr(0, 3));
  const auto index = static_cast<std::size_t>(found - names.begin());
  if (found == names.end()) return std::nullopt;
  return index < 12 ? static_cast<unsigned>(index) + 1 : german[index - 12];
}

/// `Sat Sep 30 03:06:13.191 pm 2017`. Zero, "no date", if the language is another.
nanoseconds parse_start(Words words) {
  words.next();
  const auto month = month_of(words.next());
  const auto day = parse_number(words.next(), 10);
  const auto clock = parse_clock(words.next());
  std::string_view word = words.next();
  nanoseconds half{};
  if (word == "am" || word == "AM" || word == "pm" || word == "PM") {
    const bool noon_hour = clock && *clock >= std::chrono::hours{12};
    const bool afternoon = word[0] == 'p' || word[0] == 'P';
    half = std::chrono::hours{12 * (int{afternoon} - int{noon_hour})};
    word = words.next();
  }
  const auto year = parse_number(word, 10);
  if (!month || !day || !clock || !year) return nanoseconds{0};
  const auto date = date_time(static_cast<int>(*year), *month, *day);
  return date ? *date + *clock + half : nanoseconds{0};
}

std::string in_small_letters(std::string_view word) {
  std::string small(word);
  for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return small;
}

bool is_direction(std::string_view word) {
  const std::string small = in_small_letters(word);
  return small == "rx" || small == "tx";
}

}  // namespace

bool VectorAsc::recognises(std::string_view line) {
  const std::string head = in_small_letters(line.substr(0, 8));
  if (head == "base hex" || head == "base dec") return true;
  return VectorAsc().read_line(line).record.has_value();
}

bool VectorAsc::read_head(std::string_view line) {
  Words words(line);
  const std::string word = in_small_letters(words.next());
  if (word == "date") start_ = parse_start(words);
  if (word == "begin") read_trigger(words);
  if (word == "base") {
    base_ = in_small_letters(words.next()) == "dec" ? 10 : 16;
    relative_ = in_small_letters(line).find("relative") != line.npos;
  }
  constexpr std::array<std::string_view, 6> words_of_the_head{"date", "base",  "internal",
                                                              "no",   "begin", "end"};
  return word.starts_with("//") || std::find(words_of_the_head.begin(), words_of_the_head.end(),
                                             word) != words_of_the_head.end();
}

/// `Begin Triggerblock Tue Nov 14 10:13:20.000 PM 2023`
void VectorAsc::read_trigger(Words words) {
  words.next();
  const auto triggered = parse_start(words);
  constexpr nanoseconds rounding = std::chrono::seconds{1};  // some triggers have whole seconds
  if (triggered == nanoseconds{0}) return;
  if (start_ != nanoseconds{0} && triggered + rounding > start_) return;
  note_ = start_ == nanoseconds{0}
              ? "its times count from the date of its first trigger block"
              : "its times count from the date of its first trigger block: the date of its head is "
                "later, so a converter wrote it";
  start_ = triggered;
}

Reading VectorAsc::read_line(std::string_view line) {
  Words words(line);
  const auto time = parse_time(words.next(), 9);
  if (!time) return read_head(line) ? Reading::nothing() : Reading::damage();
  if (relative_ && *time > latest_time - since_) return Reading::damage();
  since_ = relative_ ? since_ + *time : *time;
  const std::string_view word = words.next();
  if (word == "CANFD") return fast(words);
  if (word == "CANXL") return Reading::damage();           // a frame that nothing here can express
  if (!parse_number(word, 10)) return Reading::nothing();  // "Start of measurement", "CAN 1 Status"
  if (words.peek() == "ErrorFrame") return in_channel(word, unspecified_error());
  return classic(word, words);
}

bool VectorAsc::read_identifier(std::string_view word, CanFrame& frame) const {
  frame.extended = word.ends_with('x');
  if (frame.extended) word.remove_suffix(1);
  const auto id = parse_number(word, base_);
  if (!id || *id > (frame.extended ? 0x1FFFFFFFu : 0x7FFu)) return false;
  frame.id = *id;
  return true;
}

Reading VectorAsc::classic(std::string_view channel, Words words) {
  CanFrame frame;
  const std::string_view id = words.next();
  if (!is_direction(words.next())) return Reading::nothing();  // a statistic, a J1939 message
  const std::string_view kind = words.next();
  if (!read_identifier(id, frame)) return Reading::damage();
  const auto length = parse_number(words.peek(), 16);
  if (kind == "r") {
    frame.remote = true;
    frame.size = static_cast<std::uint8_t>(std::min(length.value_or(0), 8u));
    return in_channel(channel, frame);
  }
  words.next();
  if (kind != "d" || !length || *length > 15 ||
      !read_data(words, std::min(*length, 8u), base_, frame)) {
    return Reading::damage();
  }
  return in_channel(channel, frame);
}

Reading VectorAsc::fast(Words words) {
  CanFrame frame;
  const std::string_view channel = words.next();
  if (!is_direction(words.next())) return Reading::nothing();
  const std::string_view id = words.next();
  if (id == "ErrorFrame") return in_channel(channel, unspecified_error());
  if (!read_identifier(id, frame)) return Reading::damage();
  std::string_view word = words.next();
  if (word != "0" && word != "1") word = words.next();  // the first word was the message's name
  frame.bit_rate_switch = word == "1";
  words.next();  // the sender's error state
  const auto code = parse_number(words.next(), 16);
  const auto size = parse_number(words.next(), 10);
  if (!code || !size || !is_fd_size(*size) || !read_data(words, *size, base_, frame)) {
    return Reading::damage();
  }
  words.next();  // duration and length on the wire
  words.next();
  constexpr std::uint32_t remote = 0x10, fd_format = 0x1000;
  const auto flags = parse_number(words.next(), 16);
  frame.remote = *size == 0 && flags && (*flags & remote) != 0;
  frame.fd = !frame.remote && (*size > 8 || !flags || (*flags & fd_format) != 0);
  if (frame.remote) frame.size = static_cast<std::uint8_t>(std::min(*code, 8u));
  frame.bit_rate_switch = frame.bit_rate_switch && frame.fd;
  return in_channel(channel, frame);
}

Reading VectorAsc::in_channel(std::string_view channel, const CanFrame& frame) {
  const auto number = parse_number(channel, 10);
  if (!number || *number == 0) return Reading::damage();
  interface_ = "can" + std::to_string(*number - 1);
  return {Record{start_ + since_, interface_, frame}, false};
}

}  // namespace drydock::capture
