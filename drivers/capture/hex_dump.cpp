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
constexpr std::size_t longest_dump_line = 1024;

std::optional<std::uint64_t> number_of_place(std::string_view text, int base) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

bool is_digit_at(std::string_view text, std::size_t at) {
  return at < text.size() && hex_digits.find(text[at]) != std::string_view::npos;
}

/// Without the letters. xxd has them behind two blanks; `hexdump -C` between `|`, and two blanks
/// inside of its digits too.
std::string_view digits_of(std::string_view text, bool of_xxd) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  if (const auto bar = text.find('|'); !of_xxd && bar != std::string_view::npos)
    return text.substr(0, bar);
  return text.substr(0, text.find("  "));
}

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

std::optional<HexDump::Line> HexDump::line_of(std::string_view text) {
  constexpr std::size_t shortest_place = 4;
  const auto place = std::min(text.find_first_not_of(hex_digits), text.size());
  if (place < shortest_place) return {};
  Line line{text.substr(0, place), {}};
  text.remove_prefix(place);
  const bool of_xxd = text.starts_with(':');
  if (of_xxd) text.remove_prefix(1);
  if (!text.empty() && text[0] != ' ' && text[0] != '\t') return {};
  const std::string_view digits = digits_of(text, of_xxd);
  for (std::size_t at = 0; at < digits.size();) {
    if (digits[at] == ' ') {
      ++at;
    } else if (is_digit_at(digits, at) && is_digit_at(digits, at + 1)) {
      std::uint8_t byte = 0;
      std::from_chars(digits.data() + at, digits.data() + at + 2, byte, 16);
      line.bytes.push_back(byte);
      at += 2;
    } else {
      return {};
    }
  }
  if (line.place.size() == od_place && has_words(digits)) swap_pairs(line.bytes);
  return line;
}

bool HexDump::goes_on(wire::Bytes bytes) {
  std::string_view text = wire::as_text(bytes);
  cut_line(text);
  const std::string_view second = cut_line(text);
  return second.empty() || second == "*" || line_of(second).has_value();
}

bool HexDump::recognises(wire::Bytes bytes) {
  std::string_view text = wire::as_text(bytes);
  const auto first = line_of(cut_line(text));
  std::string_view next = cut_line(text);
  if (next == "*") next = cut_line(text);
  const auto second = line_of(next);
  if (!first || !second || first->bytes.size() < 2) return false;
  for (const int base : {16, 8}) {
    const auto from = number_of_place(first->place, base),
               to = number_of_place(second->place, base);
    if (from && to && *to > *from && (*to - *from) % first->bytes.size() == 0) return *from == 0;
  }
  return false;
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
  const auto line = text.size() > longest_dump_line ? std::nullopt : line_of(text);
  if (!line) {
    ++odd_lines_;
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
