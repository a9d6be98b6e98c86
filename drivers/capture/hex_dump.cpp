#include "drivers/capture/hex_dump.hpp"

#include <algorithm>
#include <charconv>

#include "drivers/wire/text_fields.hpp"

namespace drydock::capture {
namespace {

constexpr std::string_view hex_digits = "0123456789abcdefABCDEF";
/// Digits of a place of od, and of hexdump where it prints words.
constexpr std::size_t od_place = 7;
/// Repeats of more in one block are taken for damage: a few letters may ask for any number of
/// bytes.
constexpr std::uint64_t most_repeated = 1u << 24;
constexpr std::size_t longest_dump_line = HexDump::any_width;

std::optional<std::uint64_t> number_of_place(std::string_view text, int base) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

bool is_digit_at(std::string_view text, std::size_t at) {
  return at < text.size() && hex_digits.find(text[at]) != std::string_view::npos;
}

/// Bytes in front of the gap in a line; and the least characters of one with a place for letters
/// behind sixteen.
constexpr std::size_t half_line = 8, shortest_padded = 58;

/// hexdump and `od -x` print words of this computer's order, the low byte first in the file.
bool has_words(std::string_view digits) {
  constexpr std::size_t size = 4;
  return digits.substr(0, digits.find(' ')).size() == size;
}

void swap_pairs(std::vector<std::uint8_t>& bytes) {
  for (std::size_t i = 1; i < bytes.size(); i += 2) std::swap(bytes[i - 1], bytes[i]);
}

/// Takes the first line off the text.
std::string_view cut_line(std::string_view& text) {
  const auto end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace

std::optional<std::vector<std::uint8_t>> pairs_of_dump(std::string_view text, bool of_xxd,
                                                       std::size_t most) {
  std::vector<std::uint8_t> bytes;
  std::size_t gap = 0;
  for (std::size_t at = 0; at < text.size() && bytes.size() < most;) {
    if (text[at] == ' ' || text[at] == '\t') {
      ++at;
      ++gap;
      continue;
    }
    const bool behind_gap = !bytes.empty() && gap > 1;
    if (behind_gap && (of_xxd || gap > 2 || bytes.size() != half_line)) break;
    if (!is_digit_at(text, at) || !is_digit_at(text, at + 1)) {
      if (behind_gap || (!of_xxd && text[at] == '|')) break;
      return {};
    }
    std::uint8_t byte = 0;
    std::from_chars(text.data() + at, text.data() + at + 2, byte, 16);
    bytes.push_back(byte);
    at += 2;
    gap = 0;
  }
  return bytes;
}

std::optional<HexDump::Line> HexDump::line_of(std::string_view text, std::size_t most) {
  constexpr std::size_t shortest_place = 4;
  const auto indent = std::min(text.find_first_not_of(" \t"), text.size());
  text.remove_prefix(indent);
  const auto place = std::min(text.find_first_not_of(hex_digits), text.size());
  if (place < shortest_place) return {};
  Line line{indent, text.substr(0, place), {}};
  text.remove_prefix(place);
  const bool of_xxd = text.starts_with(':');
  if (of_xxd) text.remove_prefix(1);
  if (!text.empty() && text[0] != ' ' && text[0] != '\t') return {};
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  auto bytes = pairs_of_dump(text, of_xxd, most);
  if (!bytes) return {};
  line.bytes = std::move(*bytes);
  if (line.place.size() == od_place && has_words(text)) swap_pairs(line.bytes);
  return line;
}

bool HexDump::goes_on(wire::Bytes bytes) {
  std::string_view text = wire::as_text(bytes);
  cut_line(text);
  const std::string_view second = cut_line(text);
  return second.empty() || second == "*" || line_of(second, any_width).has_value();
}

std::optional<HexDump::Layout> HexDump::layout_of(wire::Bytes bytes) {
  constexpr std::size_t longest_head = 8;  // `Follow: tcp,hex`, `Node 0: ...`
  std::string_view text = wire::as_text(bytes);
  for (std::size_t head = 0; head <= longest_head && !text.empty(); ++head) {
    const std::string_view line = cut_line(text);
    const auto first = line_of(line, any_width);
    if (!first || first->bytes.size() < 2) continue;
    std::string_view rest = text, next = cut_line(rest);
    const bool repeats = next == "*";
    if (repeats) next = cut_line(rest);
    const auto second = line_of(next, any_width);
    if (!second || second->indent != first->indent) return {};
    for (const int base : {16, 8}) {
      const auto from = number_of_place(first->place, base),
                 to = number_of_place(second->place, base);
      if (!from || !to || *from != 0 || *to == 0) continue;
      // A segment of a stream may end in the first line, so that the next ones are longer.
      const bool is_narrow = *to == half_line && line.size() < shortest_padded;
      const std::size_t most = is_narrow ? half_line : std::max<std::size_t>(*to, 2 * half_line);
      const auto whole = line_of(line, most);
      if (whole && (repeats ? *to % whole->bytes.size() == 0 : *to == whole->bytes.size()))
        return Layout{first->indent, most};
    }
    return {};
  }
  return {};
}

void HexDump::begin(wire::Bytes head) {
  if (const auto layout = layout_of(head)) layout_ = *layout;
}

wire::Bytes HexDump::of(wire::Bytes block) {
  bytes_.clear();
  may_repeat_ = most_repeated;
  for (const char letter : wire::as_text(block)) {
    if (letter != '\n') {
      if (waiting_.size() <= longest_dump_line) waiting_.push_back(letter);
      continue;
    }
    if (waiting_.ends_with('\r')) waiting_.pop_back();
    take(waiting_);
    waiting_.clear();
  }
  return bytes_;
}

wire::Bytes HexDump::finish() {
  constexpr std::uint8_t end[] = {'\n'};
  return of(end);
}

void HexDump::take(std::string_view text) {
  if (text.empty()) return;
  if (text == "*") {
    repeats_ = true;
    return;
  }
  const auto line = text.size() > longest_dump_line ? std::nullopt : line_of(text, layout_.width);
  if (!line || line->indent != layout_.indent) {
    ++(line ? others_ : odd_lines_);
    return;
  }
  if (base_ == 0 && next_ > 0) {
    const bool octal =
        repeats_ ? line->place.size() == od_place : number_of_place(line->place, 16) != next_;
    base_ = octal ? 8 : 16;
  }
  if (repeats_)
    if (const auto place = number_of_place(line->place, base_ == 0 ? 16 : base_))
      repeat_until(*place);
  repeats_ = false;
  bytes_.insert(bytes_.end(), line->bytes.begin(), line->bytes.end());
  next_ += line->bytes.size();
  last_ = line->bytes;
}

void HexDump::repeat_until(std::uint64_t place) {
  if (last_.empty() || place < next_ || place - next_ > may_repeat_) {
    ++odd_lines_;
    next_ = place;
    return;
  }
  may_repeat_ -= place - next_;
  for (; next_ < place; next_ += last_.size())
    bytes_.insert(bytes_.end(), last_.begin(), last_.end());
}

}  // namespace drydock::capture
