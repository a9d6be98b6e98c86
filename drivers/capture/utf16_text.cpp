#include "drivers/capture/utf16_text.hpp"

#include <algorithm>

namespace drydock::capture {
namespace {

constexpr std::uint8_t mark_low = 0xFE, mark_high = 0xFF;
constexpr std::uint32_t byte_order_mark = 0xFEFF, replacement = 0xFFFD;

constexpr std::uint8_t byte_of(std::uint32_t value) { return static_cast<std::uint8_t>(value); }

}  // namespace

bool Utf16Text::recognises(wire::Bytes head) {
  constexpr std::size_t mark = 2, letters = 8;
  if (head.size() < 2 * mark) return false;
  const bool big_endian = head[0] == mark_low && head[1] == mark_high;
  if (!big_endian && !(head[0] == mark_high && head[1] == mark_low)) return false;
  for (std::size_t at = mark; at + 1 < std::min(head.size(), mark + 2 * letters); at += 2) {
    const auto high = head[big_endian ? at : at + 1], low = head[big_endian ? at + 1 : at];
    if (high != 0 || low == 0 || low > 0x7F) return false;
  }
  return true;
}

wire::Bytes Utf16Text::of(wire::Bytes block) {
  text_.clear();
  if (!begun_ && !block.empty()) {
    big_endian_ = block[0] == mark_low;
    begun_ = true;
  }
  for (const std::uint8_t byte : block) {
    if (!half_) {
      half_ = byte;
      continue;
    }
    const std::uint32_t first = *half_, second = byte;
    half_.reset();
    take(big_endian_ ? first << 8 | second : second << 8 | first);
  }
  return text_;
}

void Utf16Text::take(std::uint32_t unit) {
  const bool is_high = unit >= 0xD800 && unit < 0xDC00, is_low = unit >= 0xDC00 && unit < 0xE000;
  if (high_ && is_low) {
    put(0x10000 + ((*high_ - 0xD800) << 10) + (unit - 0xDC00));
    high_.reset();
    return;
  }
  if (high_) put(replacement);
  high_.reset();
  if (is_high)
    high_ = unit;
  else if (is_low)
    put(replacement);
  else if (unit != byte_order_mark)
    put(unit);
}

void Utf16Text::put(std::uint32_t letter) {
  const auto tail = [&](unsigned shift) {
    text_.push_back(byte_of(0x80 | ((letter >> shift) & 0x3F)));
  };
  if (letter < 0x80) {
    text_.push_back(byte_of(letter));
  } else if (letter < 0x800) {
    text_.push_back(byte_of(0xC0 | letter >> 6));
    tail(0);
  } else if (letter < 0x10000) {
    text_.push_back(byte_of(0xE0 | letter >> 12));
    tail(6);
    tail(0);
  } else {
    text_.push_back(byte_of(0xF0 | letter >> 18));
    tail(12);
    tail(6);
    tail(0);
  }
}

}  // namespace drydock::capture
