#include "drivers/capture/byte_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace drydock::capture {
namespace {

bool is_space(std::uint8_t byte) {
  return byte == '\r' || byte == '\n' || byte == ' ' || byte == '\t';
}

std::optional<std::uint8_t> hex_digit(std::uint8_t letter) {
  if (letter >= '0' && letter <= '9') return static_cast<std::uint8_t>(letter - '0');
  const int from_a = (letter | 0x20) - 'a';
  if (from_a < 0 || from_a > 5) return std::nullopt;
  return static_cast<std::uint8_t>(10 + from_a);
}

/// Hexadecimal ones, in lines.
bool is_digits(wire::Bytes text) {
  return std::ranges::all_of(text, [](std::uint8_t byte) {
    return is_space(byte) || hex_digit(byte).has_value();
  });
}

bool same_letter(std::uint8_t byte, char upper) { return byte == upper || byte == (upper | 0x20); }

}  // namespace

bool is_hex_text(wire::Bytes text) {
  constexpr std::array sync{'7', 'F', '7', 'F'};
  constexpr std::size_t fewest = 16;  // the header of an ensemble and its first offset
  // In binary bytes the first or second one ends the first question, so it comes first.
  if (text.size() < fewest || !is_digits(text)) return false;
  return std::search(text.begin(), text.end(), sync.begin(), sync.end(), same_letter) != text.end();
}

bool is_hex_pairs(wire::Bytes text) {
  constexpr std::size_t fewest = 16;
  std::size_t pairs = 0, digits = 0;
  bool has_letter = false;
  for (const std::uint8_t letter : text) {
    if (is_space(letter)) {
      if (digits == 1) return false;
      digits = 0;
      continue;
    }
    if (!hex_digit(letter) || ++digits > 2) return false;
    if (digits == 2) ++pairs;
    has_letter = has_letter || letter > '9';
  }
  return has_letter && pairs >= fewest;
}

wire::Bytes ByteContent::of(wire::Bytes block) {
  if (raw_) return block;
  const wire::Bytes content = head_.without(block);
  if (form_ == Form::undecided && !content.empty()) form_ = form_of(content);
  switch (form_) {
    case Form::hex: return decoded(content);
    case Form::dump: return dump_.of(content);
    case Form::json: return json_.of(content);
    case Form::undecided:
    case Form::lines: break;
  }
  return stamps_.without(content);
}

ByteContent::Form ByteContent::form_of(wire::Bytes text) {
  // The digits of a dump may be those of an ensemble, so that its places are looked at first.
  if (HexDump::recognises(text)) return Form::dump;
  if (is_hex_text(text) || is_hex_pairs(text)) return Form::hex;
  return JsonDocuments::recognises(text) ? Form::json : Form::lines;
}

bool ByteContent::begins_anew(wire::Bytes head) const {
  if (raw_ || form_ == Form::undecided) return false;
  CommentHead comments;
  const wire::Bytes text = comments.without(head);
  return comments.size() > 0 || is_other(form_of(text), text);
}

/// The rest of a dump or of digits that were cut in a line may look like lines.
bool ByteContent::is_other(Form form, wire::Bytes text) const {
  if (form == Form::dump || form == Form::json) return true;
  if (form == Form::hex) return form_ != Form::hex;
  if (form_ == Form::dump) return !HexDump::goes_on(text);
  if (form_ == Form::hex) return !is_digits(text);
  if (form_ == Form::json) return false;
  const auto front = front_of_sentences(text);
  return front && stamps_.front() && *front != *stamps_.front();
}

std::string ByteContent::note() const {
  if (form_ == Form::hex) return "hexadecimal text, read as the bytes that it means";
  if (form_ == Form::json) return "JSON in a list or over several lines, read as an object a line";
  if (form_ == Form::dump) {
    std::string dump = "a hexadecimal dump, read as the bytes that it means";
    if (const auto odd = dump_.odd_lines(); odd > 0)
      dump += fmt::format("; lines of another form are left out: {}", odd);
    return dump;
  }
  if (stamps_.lines() == 0) return {};
  const std::string_view are = stamps_.timed_lines() == 0 ? "were left out"
                               : stamps_.whole_seconds()  ? "are their times, in whole seconds"
                                                          : "are their times";
  return fmt::format("a logger's stamps around {} {} {} (format=raw keeps them)", stamps_.lines(),
                     stamps_.kind() == TextLine::sentence ? "sentences" : "lines", are);
}

std::span<const SentenceStamps::Timed> ByteContent::times() const {
  if (raw_ || form_ != Form::lines) return {};
  return stamps_.times();
}

/// A half byte at the end of a line is none: the next line begins with a whole one.
wire::Bytes ByteContent::decoded(wire::Bytes digits) {
  bytes_.clear();
  for (const std::uint8_t letter : digits) {
    const auto digit = hex_digit(letter);
    if (digit && half_) bytes_.push_back(static_cast<std::uint8_t>(*half_ << 4 | *digit));
    half_ = digit && !half_ ? digit : std::nullopt;
  }
  return bytes_;
}

}  // namespace drydock::capture
