#include "drivers/wire/nmea0183/nmea0183.hpp"

#include <algorithm>
#include <cstring>

#include "drivers/wire/checksum.hpp"
#include "drivers/wire/line_end.hpp"
#include "drivers/wire/nmea0183/nmea0183_decode.hpp"

namespace drydock::wire {
namespace {

constexpr int hex_value(std::uint8_t c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return -1;
}

constexpr std::uint64_t every_byte(std::uint8_t value) { return value * 0x0101'0101'0101'0101u; }

/// True if one of the eight characters is `*`, `$`, or not permitted in a sentence. The high bit
/// marks such a character: a byte minus a larger one borrows; DEL or a larger byte plus one reaches
/// 0x80.
constexpr bool ends_text(std::uint64_t word) {
  const auto below = [](std::uint64_t bytes, std::uint8_t limit) {
    return (bytes - every_byte(limit)) & ~bytes;
  };
  return ((below(word, 0x20) | below(word ^ every_byte('*'), 1) | below(word ^ every_byte('$'), 1) |
           word | (word + every_byte(1))) &
          every_byte(0x80)) != 0;
}

/// `star` is the position of the checksum. Nothing before it can start another sentence.
Scan with_checksum(Bytes bytes, std::size_t star, std::uint8_t checksum) {
  int sent = 0;
  for (std::size_t i = star + 1; i < star + 3; ++i) {
    if (i == bytes.size()) return Scan::need_more();
    const int digit = hex_value(bytes[i]);
    if (digit < 0) return Scan::skip(i);
    sent = sent * 16 + digit;
  }
  return sent == checksum ? with_line_end(bytes, star + 3) : Scan::bad_checksum();
}

/// IEC 61162-1: `!` begins an encapsulation sentence, as those of AIS are.
constexpr bool begins_sentence(std::uint8_t c) { return c == '$' || c == '!'; }

/// Bytes up to the next one that may begin a frame: a sentence, or a TAG block.
std::size_t before_start(Bytes bytes) {
  const auto find = [](Bytes in, char what) {
    const auto* at = static_cast<const std::uint8_t*>(std::memchr(in.data(), what, in.size()));
    return at != nullptr ? static_cast<std::size_t>(at - in.data()) : in.size();
  };
  const Bytes plain = bytes.first(find(bytes, '$'));
  return find(plain.first(find(plain, '!')), '\\');
}

Scan scan_sentence(Bytes bytes);

/// `\...*hh\` and the sentence behind it.
Scan scan_tagged(Bytes bytes) {
  constexpr std::size_t longest_tag = 80;  // NMEA 0183 4.00
  std::uint8_t checksum = 0;
  std::size_t star = 0;
  for (std::size_t i = 1; i < longest_tag + 1; ++i) {
    if (i == bytes.size()) return Scan::need_more();
    const std::uint8_t c = bytes[i];
    if (c == '\\') {
      if (star == 0 || i != star + 3) return Scan::skip(i);
      const int high = hex_value(bytes[star + 1]), low = hex_value(bytes[star + 2]);
      if (high < 0 || low < 0 || checksum != high * 16 + low) return Scan::skip(i);
      if (i + 1 == bytes.size()) return Scan::need_more();
      if (!begins_sentence(bytes[i + 1])) return Scan::skip(i + 1);
      const Scan sentence = scan_sentence(bytes.subspan(i + 1));
      switch (sentence.kind) {
        case Scan::Kind::frame: return Scan::frame(i + 1 + sentence.size);
        case Scan::Kind::need_more: return sentence;
        default: return Scan::skip(i + 1);  // the sentence is looked at without it
      }
    }
    if (c == '$' || c < 0x20 || c > 0x7e) return Scan::skip(i);
    if (c == '*') star = i;
    if (star == 0) checksum ^= c;
  }
  return Scan::skip(1);
}

Scan scan_sentence(Bytes bytes) {
  constexpr std::size_t tail = 5;  // *hh CR LF
  const Bytes body = bytes.first(std::min(bytes.size(), Nmea0183::max_frame - tail + 1));
  std::size_t i = 1;
  std::uint64_t words = 0;
  for (; i + 8 <= body.size(); i += 8) {
    const auto word = load_le<std::uint64_t>(body, i);
    if (ends_text(word)) break;
    words ^= word;
  }
  std::uint8_t checksum = xor_of_bytes(words);
  for (; i < body.size(); ++i) {
    const std::uint8_t c = body[i];
    if (c == '*') return with_checksum(bytes, i, checksum);
    if (c == '$' || c < 0x20 || c > 0x7e) return Scan::skip(i);
    checksum ^= c;
  }
  return body.size() < bytes.size() ? Scan::skip(1) : Scan::need_more();
}

}  // namespace

Scan Nmea0183::scan(Bytes bytes) {
  if (bytes.empty()) return Scan::need_more();
  if (begins_sentence(bytes[0])) return scan_sentence(bytes);
  return bytes[0] == '\\' ? scan_tagged(bytes) : Scan::skip(before_start(bytes));
}

std::optional<Nmea0183::Message> Nmea0183::decode(Bytes frame) {
  return decode_nmea0183<Message>(frame);
}

}  // namespace drydock::wire
