#include "drivers/capture/sentence_stamps.hpp"

#include <algorithm>
#include <string_view>

#include "drivers/capture/logger_time.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::capture {
namespace {

using std::chrono::nanoseconds;
using wire::Bytes;

bool ends_line(std::uint8_t byte) { return byte == '\r' || byte == '\n'; }
bool begins_sentence(std::uint8_t byte) { return byte == '$' || byte == '!'; }
bool is_text(std::uint8_t byte) { return byte == '\t' || (byte >= 0x20 && byte < 0x7F); }

std::optional<unsigned> digit(char c) {
  constexpr std::string_view upper = "0123456789ABCDEF", lower = "0123456789abcdef";
  const auto at = std::min(upper.find(c), lower.find(c));
  return at == upper.npos ? std::nullopt : std::optional(static_cast<unsigned>(at));
}

/// `$...*hh` with a right checksum at the front of the text, which nothing but a mark follows.
bool is_sentence(std::string_view text) {
  const auto star = text.find('*');
  if (star == text.npos || star + 3 > text.size() || star + 4 < text.size()) return false;
  const auto high = digit(text[star + 1]), low = digit(text[star + 2]);
  unsigned sum = 0;
  for (const char c : text.substr(1, star - 1)) sum ^= static_cast<std::uint8_t>(c);
  return high && low && sum == *high * 16 + *low;
}

/// `$PUHAW,UVH,...` without a checksum, behind a time: the name and the time show what is what.
bool is_named_behind_time(std::string_view before, std::string_view text) {
  constexpr std::size_t shortest_name = 3;
  const std::string_view name = text.substr(1, text.find(',') - 1);
  const bool is_name = text.find(',') != text.npos && name.size() >= shortest_name &&
                       std::ranges::all_of(name, [](char c) {
                         return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
                       });
  return is_name && text.find('*') == text.npos && logger_time(before).has_value();
}

enum class Line : std::uint8_t { other, bare, stamped, tagged };

Line kind_of(Bytes line) {
  if (!std::ranges::all_of(line, is_text)) return Line::other;
  const auto start = std::ranges::find_if(line, begins_sentence);
  const auto at = static_cast<std::size_t>(start - line.begin());
  if (start == line.end()) return Line::other;
  const std::string_view before = wire::as_text(line.first(at)),
                         text = wire::as_text(line.subspan(at));
  if (!is_sentence(text)) return is_named_behind_time(before, text) ? Line::stamped : Line::other;
  if (at == 0) return Line::bare;
  return line[0] == '\\' ? Line::tagged : Line::stamped;
}

}  // namespace

std::optional<SentenceFront> front_of_sentences(Bytes text) {
  constexpr std::size_t fewest = 3;
  std::size_t lines = 0, stamped = 0, tagged = 0;
  while (true) {
    const auto end = std::ranges::find_if(text, ends_line);
    if (end == text.end()) break;  // the last line is not whole
    const auto size = static_cast<std::size_t>(end - text.begin());
    if (size > 0) {
      ++lines;
      stamped += kind_of(text.first(size)) == Line::stamped;
      tagged += kind_of(text.first(size)) == Line::tagged;
    }
    text = text.subspan(size + 1);
  }
  if (lines < fewest) return {};
  if (10 * stamped >= 9 * lines) return SentenceFront::stamp;
  // Of a group of sentences only the first one has a TAG block.
  return 4 * tagged >= lines ? SentenceFront::tag_block : SentenceFront::nothing;
}

Bytes SentenceStamps::without(Bytes block) {
  times_.clear();
  if (!front_) front_ = front_of_sentences(block);
  if (front_.value_or(SentenceFront::nothing) == SentenceFront::nothing) return block;
  bytes_.clear();
  for (const std::uint8_t byte : block) take(byte);
  return bytes_;
}

/// Of the text in front of the sentence that begins now.
void SentenceStamps::read_time() {
  const auto text = wire::as_text(before_);
  const auto found =
      front_ == SentenceFront::stamp ? logger_time(text, order_) : tag_block_time(text);
  if (!found) return;
  if (found->order != DateOrder::unknown) order_ = found->order;
  if (!dated_) dated_ = !found->of_day;
  if (*dated_ && found->of_day) return;  // a torn stamp
  ++timed_;
  whole_seconds_ = whole_seconds_ && found->whole_second;
  constexpr std::chrono::hours day{24};
  last_ = steady_.of(
      "", *dated_ ? found->time : days_.since_first_midnight(found->time % nanoseconds{day}));
}

/// A line without a sentence stays as it is.
void SentenceStamps::end_line() {
  bytes_.insert(bytes_.end(), before_.begin(), before_.end());
  before_.clear();
  in_sentence_ = false;
  behind_star_ = 0;
}

void SentenceStamps::take(std::uint8_t byte) {
  constexpr std::size_t longest_stamp = 256;
  if (ends_line(byte)) {
    end_line();
    bytes_.push_back(byte);
    if (byte == '\n' && last_) times_.push_back({bytes_.size(), *last_});
    return;
  }
  if (!in_sentence_ && begins_sentence(byte)) {
    read_time();
    if (front_ == SentenceFront::tag_block)
      bytes_.insert(bytes_.end(), before_.begin(), before_.end());
    lines_ += front_ == SentenceFront::stamp && !before_.empty();
    before_.clear();
    in_sentence_ = true;
  }
  if (!in_sentence_) {
    before_.push_back(byte);
    if (before_.size() <= longest_stamp) return;
    bytes_.insert(bytes_.end(), before_.begin(), before_.end());
    before_.clear();
    return;
  }
  constexpr unsigned checksum = 3;  // *hh
  if (behind_star_ > 0 || byte == '*') ++behind_star_;
  const bool is_mark = front_ == SentenceFront::stamp && behind_star_ > checksum;
  if (!is_mark) bytes_.push_back(byte);
}

}  // namespace drydock::capture
