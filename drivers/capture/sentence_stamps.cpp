#include "drivers/capture/sentence_stamps.hpp"

#include <algorithm>
#include <string_view>

#include "drivers/wire/text_fields.hpp"

namespace drydock::capture {
namespace {

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

enum class Line : std::uint8_t { other, bare, stamped };

Line kind_of(Bytes line) {
  if (!std::ranges::all_of(line, is_text)) return Line::other;
  const auto start = std::ranges::find_if(line, begins_sentence);
  const auto at = static_cast<std::size_t>(start - line.begin());
  const bool sound = start != line.end() && is_sentence(wire::as_text(line.subspan(at)));
  if (!sound) return Line::other;
  return at == 0 || line[0] == '\\' ? Line::bare : Line::stamped;
}

}  // namespace

std::optional<bool> has_sentence_stamps(Bytes text) {
  constexpr std::size_t fewest = 3;
  std::size_t lines = 0, stamped = 0;
  while (true) {
    const auto end = std::ranges::find_if(text, ends_line);
    if (end == text.end()) break;  // the last line is not whole
    const auto size = static_cast<std::size_t>(end - text.begin());
    if (size > 0) {
      ++lines;
      stamped += kind_of(text.first(size)) == Line::stamped;
    }
    text = text.subspan(size + 1);
  }
  if (lines < fewest) return {};
  return 10 * stamped >= 9 * lines;
}

Bytes SentenceStamps::without(Bytes block) {
  if (!stamped_) stamped_ = has_sentence_stamps(block);
  if (!stamped_.value_or(false)) return block;
  bytes_.clear();
  for (const std::uint8_t byte : block) take(byte);
  return bytes_;
}

/// A line without a sentence stays as it is.
void SentenceStamps::take(std::uint8_t byte) {
  constexpr std::size_t longest_stamp = 256;
  if (ends_line(byte)) {
    bytes_.insert(bytes_.end(), before_.begin(), before_.end());
    bytes_.push_back(byte);
    before_.clear();
    in_sentence_ = false;
    behind_star_ = 0;
    return;
  }
  if (!in_sentence_ && begins_sentence(byte)) {
    lines_ += !before_.empty();
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
  if (behind_star_ <= checksum) bytes_.push_back(byte);  // behind it stands a mark
}

}  // namespace drydock::capture
