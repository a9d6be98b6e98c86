#include "drivers/capture/sentence_stamps.hpp"

#include "drivers/capture/logger_time.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::capture {

using wire::Bytes;

void SentenceStamps::decide(Bytes block) {
  front_ = front_of_sentences(block);
  if (front_ == SentenceFront::stamp && are_pauses(block)) clock_.sum_pauses();
  if (front_ != SentenceFront::nothing) return;
  if (const auto kind = lines_behind_times(block)) {
    front_ = SentenceFront::stamp;
    kind_ = *kind;
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

bool SentenceStamps::is_time_line() const {
  return front_ == SentenceFront::time_lines && !in_sentence_ &&
         is_time_alone(wire::as_text(before_));
}

/// A line without a sentence stays as it is.
void SentenceStamps::end_line() {
  if (is_time_line()) {
    clock_.take(logger_time(wire::as_text(before_), clock_.order()));
    ++lines_;
  } else {
    bytes_.insert(bytes_.end(), before_.begin(), before_.end());
  }
  before_.clear();
  in_sentence_ = in_sent_ = false;
  behind_star_ = 0;
}

/// Its first characters are the last ones of what came before it.
void SentenceStamps::begin_sentence(std::size_t begin) {
  const std::vector<std::uint8_t> first(before_.end() - static_cast<std::ptrdiff_t>(begin),
                                        before_.end());
  before_.erase(before_.end() - static_cast<std::ptrdiff_t>(begin), before_.end());
  const auto text = wire::as_text(before_);
  if (front_ == SentenceFront::stamp) {
    clock_.take(logger_time(text, clock_.order()));
    in_sent_ = is_of_sent(text);
    lines_ += !before_.empty();
    sent_ += in_sent_;
  } else {
    if (front_ == SentenceFront::tag_block) clock_.take(tag_block_time(text));
    bytes_.insert(bytes_.end(), before_.begin(), before_.end());
  }
  before_.clear();
  if (!in_sent_) bytes_.insert(bytes_.end(), first.begin(), first.end());
  in_sentence_ = true;
}

void SentenceStamps::take_in_front(std::uint8_t byte) {
  constexpr std::size_t longest_stamp = 256;
  before_.push_back(byte);
  if (const std::size_t begin = begin_behind(wire::as_text(before_), kind_)) {
    begin_sentence(begin);
  } else if (before_.size() > longest_stamp) {
    bytes_.insert(bytes_.end(), before_.begin(), before_.end());
    before_.clear();
  }
}

void SentenceStamps::take(std::uint8_t byte) {
  if (byte == '\r' || byte == '\n') {
    end_line();
    bytes_.push_back(byte);
    if (byte == '\n' && clock_.last()) times_.push_back({bytes_.size(), *clock_.last()});
    return;
  }
  if (!in_sentence_) return take_in_front(byte);
  constexpr unsigned checksum = 3;  // *hh
  if (has_checksum(kind_) && (behind_star_ > 0 || byte == '*')) ++behind_star_;
  const bool is_mark = front_ == SentenceFront::stamp && behind_star_ > checksum;
  if (!is_mark && !in_sent_) bytes_.push_back(byte);
}

}  // namespace drydock::capture
