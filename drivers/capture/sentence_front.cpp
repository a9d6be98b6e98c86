#include "drivers/capture/sentence_front.hpp"

#include <algorithm>
#include <chrono>

#include "drivers/capture/logger_time.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::capture {
namespace {

using wire::Bytes;

bool ends_text_line(std::uint8_t byte) { return byte == '\r' || byte == '\n'; }
bool is_text(std::uint8_t byte) { return byte == '\t' || (byte >= 0x20 && byte < 0x7F); }

/// `GPHDT` in `$GPHDT,...`
bool has_name(std::string_view sentence) {
  constexpr std::size_t shortest_name = 3;
  const std::size_t comma = sentence.find(',');
  return comma != sentence.npos && comma > shortest_name &&
         std::ranges::all_of(sentence.substr(1, comma - 1), [](char c) {
           return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
         });
}

enum class Line : std::uint8_t {
  other,
  bare,
  stamped,
  tagged,
  time,        ///< alone
  torn,        ///< behind a time: a sentence with a wrong checksum
  behind_time  ///< something else
};

Line kind_of(Bytes line) {
  constexpr std::size_t longest_front = 48;
  if (!std::ranges::all_of(line, is_text)) return Line::other;
  const auto whole = wire::as_text(line);
  const std::size_t at = begin_in(whole, TextLine::sentence);
  const std::string_view before = whole.substr(0, at), text = whole.substr(at);
  if (text.empty()) {
    if (is_time_alone(whole)) return Line::time;
    return logger_time(whole.substr(0, longest_front)) ? Line::behind_time : Line::other;
  }
  if (is_whole(text, TextLine::sentence))
    return at == 0 ? Line::bare : line[0] == '\\' ? Line::tagged : Line::stamped;
  if (!logger_time(before)) return Line::other;
  // `$PUHAW,UVH,...` without a checksum: the name and the time show what is what.
  return has_name(text) && text.find('*') == text.npos ? Line::stamped : Line::torn;
}

bool is_behind_time(Bytes line, TextLine kind) {
  if (!std::ranges::all_of(line, is_text)) return false;
  const auto text = wire::as_text(line);
  const std::size_t at = begin_in(text, kind);
  return at < text.size() && is_whole(text.substr(at), kind) &&
         logger_time(text.substr(0, at)).has_value();
}

/// Calls with each whole line of the text that is not empty.
template <typename Action>
void for_each_line(Bytes text, const Action& action) {
  while (true) {
    const auto end = std::ranges::find_if(text, ends_text_line);
    if (end == text.end()) return;  // the last line is not whole
    const auto size = static_cast<std::size_t>(end - text.begin());
    if (size > 0) action(text.first(size));
    text = text.subspan(size + 1);
  }
}

bool nearly_all(std::size_t some, std::size_t lines) { return 10 * some >= 9 * lines; }

constexpr std::size_t fewest_lines = 3;

}  // namespace

std::size_t begin_in(std::string_view text, TextLine kind) {
  for (std::size_t end = 1; end <= text.size(); ++end)
    if (const std::size_t size = begin_behind(text.substr(0, end), kind)) return end - size;
  return text.size();
}

bool is_time_alone(std::string_view line) {
  constexpr std::string_view characters = "0123456789:-/.,TZ+ []";
  constexpr std::size_t longest = 40;
  return line.size() <= longest && line.find(':') != line.npos &&
         line.find_first_not_of(characters) == line.npos && logger_time(line).has_value();
}

std::optional<SentenceFront> front_of_sentences(Bytes text) {
  std::size_t lines = 0, stamped = 0, tagged = 0, bare = 0, times = 0, timed = 0;
  for_each_line(text, [&](Bytes line) {
    const Line kind = kind_of(line);
    ++lines;
    stamped += kind == Line::stamped;
    tagged += kind == Line::tagged;
    bare += kind == Line::bare;
    times += kind == Line::time;
    timed += kind == Line::torn || kind == Line::behind_time;
  });
  if (lines < fewest_lines) return {};
  if (4 * stamped >= lines && nearly_all(stamped + timed + times, lines))
    return SentenceFront::stamp;
  // Of a group of sentences only the first one has a TAG block.
  if (4 * tagged >= lines) return SentenceFront::tag_block;
  const bool often = times >= 2 && 50 * times >= lines && bare >= times;
  return often && nearly_all(bare + times, lines) ? SentenceFront::time_lines
                                                  : SentenceFront::nothing;
}

std::optional<TextLine> lines_behind_times(Bytes text) {
  for (const TextLine kind : {TextLine::water_linked, TextLine::pd6, TextLine::json}) {
    std::size_t lines = 0, stamped = 0;
    for_each_line(text, [&](Bytes line) {
      ++lines;
      stamped += is_behind_time(line, kind);
    });
    if (nearly_all(stamped, lines)) return kind;
  }
  return {};
}

bool are_pauses(Bytes text) {
  constexpr std::size_t few = 8;
  std::size_t times = 0, back = 0;
  std::chrono::nanoseconds last{0};
  bool small = true;
  for_each_line(text, [&](Bytes line) {
    const auto whole = wire::as_text(line);
    const auto time = logger_time(whole.substr(0, begin_in(whole, TextLine::sentence)));
    if (!time) return;
    small = small && time->of_day && time->time < std::chrono::minutes{1};
    back += times > 0 && time->time < last;
    ++times;
    last = time->time;
  });
  return small && times >= few && 4 * back >= times;
}

}  // namespace drydock::capture
