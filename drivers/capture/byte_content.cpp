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
  return std::ranges::all_of(
      text, [](std::uint8_t byte) { return is_space(byte) || hex_digit(byte).has_value(); });
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
  if (!begun_ && Utf16Text::recognises(block)) utf16_.emplace();
  begun_ = begun_ || !block.empty();
  if (utf16_) block = utf16_->of(block);
  const wire::Bytes content = head_.without(block);
  if (form_ == Form::undecided && !content.empty()) {
    form_ = form_of(content);
    if (form_ == Form::dump) dump_.begin(content);
  }
  switch (form_) {
    case Form::hex: return decoded(content);
    case Form::stamped_hex: return stamped_hex_.of(content);
    case Form::dump: return dump_.of(content);
    case Form::json: return json_.of(content);
    case Form::undecided:
    case Form::lines: break;
  }
  return stamps_.without(content);
}

wire::Bytes ByteContent::finish() {
  if (form_ == Form::dump) return dump_.finish();
  return form_ == Form::stamped_hex ? stamped_hex_.finish() : stamps_.finish();
}

ByteContent::Form ByteContent::form_of(wire::Bytes text) {
  // The digits of a dump may be those of an ensemble, so that its places are looked at first.
  if (HexDump::recognises(text)) return Form::dump;
  if (is_hex_text(text) || is_hex_pairs(text)) return Form::hex;
  if (StampedHex::recognises(text)) return Form::stamped_hex;
  return JsonDocuments::recognises(text) ? Form::json : Form::lines;
}

bool ByteContent::begins_anew(wire::Bytes head) const {
  if (raw_ || form_ == Form::undecided) return false;
  if (Utf16Text::recognises(head)) return true;
  if (utf16_) return false;
  CommentHead comments;
  const wire::Bytes text = comments.without(head);
  return comments.size() > 0 || is_other(form_of(text), text);
}

/// The rest of a dump or of digits that were cut in a line may look like lines.
bool ByteContent::is_other(Form form, wire::Bytes text) const {
  if (form == Form::dump || form == Form::json) return true;
  if (form == Form::hex || form == Form::stamped_hex) return form_ != form;
  if (form_ == Form::dump) return !HexDump::goes_on(text);
  if (form_ == Form::hex) return !is_digits(text);
  if (form_ == Form::json || form_ == Form::stamped_hex) return false;
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
    if (const auto others = dump_.lines_of_others(); others > 0)
      dump += fmt::format("; lines with another indentation, of the other side, are left out: {}",
                          others);
    return dump;
  }
  std::string stamped = form_ == Form::stamped_hex
                            ? "hexadecimal text behind a logger's times, read as the bytes that it "
                              "means at these times"
                            : note_of_stamps();
  if (const auto odd = stamped_hex_.odd_lines(); odd > 0)
    stamped += fmt::format("; lines of another form are left out: {}", odd);
  if (const auto sent = stamps_.sent_lines() + stamped_hex_.sent_lines(); sent > 0)
    stamped += fmt::format("; what the computer sent ([TX]) is left out: {} lines", sent);
  return stamped;
}

std::string ByteContent::note_of_stamps() const {
  const auto& clock = stamps_.clock();
  if (stamps_.lines() == 0) return {};
  if (stamps_.front() == SentenceFront::time_lines)
    return fmt::format(
        "a logger's times on {} lines of their own are those of the lines behind "
        "them{} (format=raw keeps them)",
        stamps_.lines(), clock.whole_seconds() ? ", in whole seconds" : "");
  const std::string_view are = clock.timed() == 0 ? "were left out"
                               : clock.pauses()   ? "are the pauses between them, summed up here"
                               : clock.whole_seconds() ? "are their times, in whole seconds"
                                                       : "are their times";
  return fmt::format("a logger's stamps around {} {} {} (format=raw keeps them)", stamps_.lines(),
                     stamps_.kind() == TextLine::sentence ? "sentences" : "lines", are);
}

std::span<const SentenceStamps::Timed> ByteContent::times() const {
  if (form_ == Form::stamped_hex) return stamped_hex_.times();
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
