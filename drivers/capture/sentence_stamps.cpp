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
bool is_text(std::uint8_t byte) { return byte == '\t' || (byte >= 0x20 && byte < 0x7F); }

/// Of the first begin of such a line in the text; the text's size: there is none.
std::size_t begin_in(std::string_view text, TextLine kind) {
  for (std::size_t end = 1; end <= text.size(); ++end)
    if (const std::size_t size = begin_behind(text.substr(0, end), kind)) return end - size;
  return text.size();
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
  const std::size_t at = begin_in(wire::as_text(line), TextLine::sentence);
  if (at == line.size()) return Line::other;
  const std::string_view before = wire::as_text(line.first(at)),
                         text = wire::as_text(line.subspan(at));
  if (!is_whole(text, TextLine::sentence))
    return is_named_behind_time(before, text) ? Line::stamped : Line::other;
  if (at == 0) return Line::bare;
  return line[0] == '\\' ? Line::tagged : Line::stamped;
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
    const auto end = std::ranges::find_if(text, ends_line);
    if (end == text.end()) return;  // the last line is not whole
    const auto size = static_cast<std::size_t>(end - text.begin());
    if (size > 0) action(text.first(size));
    text = text.subspan(size + 1);
  }
}

bool nearly_all(std::size_t some, std::size_t lines) { return 10 * some >= 9 * lines; }

}  // namespace

std::optional<SentenceFront> front_of_sentences(Bytes text) {
  constexpr std::size_t fewest = 3;
  std::size_t lines = 0, stamped = 0, tagged = 0;
  for_each_line(text, [&](Bytes line) {
    const Line kind = kind_of(line);
    ++lines;
    stamped += kind == Line::stamped;
    tagged += kind == Line::tagged;
  });
  if (lines < fewest) return {};
  if (nearly_all(stamped, lines)) return SentenceFront::stamp;
  // Of a group of sentences only the first one has a TAG block.
  return 4 * tagged >= lines ? SentenceFront::tag_block : SentenceFront::nothing;
}

void SentenceStamps::decide(Bytes block) {
  front_ = front_of_sentences(block);
  if (front_ != SentenceFront::nothing) return;
  for (const TextLine kind : {TextLine::water_linked, TextLine::pd6, TextLine::json}) {
    std::size_t lines = 0, stamped = 0;
    for_each_line(block, [&](Bytes line) {
      ++lines;
      stamped += is_behind_time(line, kind);
    });
    if (!nearly_all(stamped, lines)) continue;
    front_ = SentenceFront::stamp;
    kind_ = kind;
    return;
  }
}

Bytes SentenceStamps::without(Bytes block) {
  times_.clear();
  if (!front_) decide(block);
  if (front_.value_or(SentenceFront::nothing) == SentenceFront::nothing) return block;
  bytes_.clear();
  for (const std::uint8_t byte : block) take(byte);
  return bytes_;
}

Bytes SentenceStamps::finish() {
  times_.clear();
  bytes_.clear();
  end_line();
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

/// Its first characters are the last ones of what came before it.
void SentenceStamps::begin_sentence(std::size_t begin) {
  const std::vector<std::uint8_t> first(before_.end() - static_cast<std::ptrdiff_t>(begin),
                                        before_.end());
  before_.resize(before_.size() - begin);
  read_time();
  if (front_ == SentenceFront::tag_block)
    bytes_.insert(bytes_.end(), before_.begin(), before_.end());
  lines_ += front_ == SentenceFront::stamp && !before_.empty();
  before_.clear();
  bytes_.insert(bytes_.end(), first.begin(), first.end());
  in_sentence_ = true;
}

void SentenceStamps::take(std::uint8_t byte) {
  constexpr std::size_t longest_stamp = 256;
  if (ends_line(byte)) {
    end_line();
    bytes_.push_back(byte);
    if (byte == '\n' && last_) times_.push_back({bytes_.size(), *last_});
    return;
  }
  if (!in_sentence_) {
    before_.push_back(byte);
    if (const std::size_t begin = begin_behind(wire::as_text(before_), kind_)) {
      begin_sentence(begin);
    } else if (before_.size() > longest_stamp) {
      bytes_.insert(bytes_.end(), before_.begin(), before_.end());
      before_.clear();
    }
    return;
  }
  constexpr unsigned checksum = 3;  // *hh
  if (has_checksum(kind_) && (behind_star_ > 0 || byte == '*')) ++behind_star_;
  const bool is_mark = front_ == SentenceFront::stamp && behind_star_ > checksum;
  if (!is_mark) bytes_.push_back(byte);
}

}  // namespace drydock::capture
