#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

/// Hex text of CAN identifiers and data in candump and slcan lines.
namespace drydock::wire {

/// Parses 1 to 8 hex digits of either case, and nothing else.
inline std::optional<std::uint32_t> parse_hex(std::string_view digits) {
  std::uint32_t value = 0;
  const char* const end = digits.data() + digits.size();
  if (digits.empty() || digits.size() > 8) return std::nullopt;
  const auto [stop, error] = std::from_chars(digits.data(), end, value, 16);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

/// Parses pairs of digits into the front of `out`. False if one is invalid or they do not fit.
inline bool parse_hex_bytes(std::string_view digits, std::span<std::uint8_t> out) {
  if (digits.size() % 2 != 0 || digits.size() / 2 > out.size()) return false;
  for (std::size_t i = 0; i < digits.size() / 2; ++i) {
    const auto byte = parse_hex(digits.substr(2 * i, 2));
    if (!byte) return false;
    out[i] = static_cast<std::uint8_t>(*byte);
  }
  return true;
}

/// Upper-case hex of a frame's data.
class HexText {
 public:
  explicit HexText(std::span<const std::uint8_t> bytes) {
    constexpr std::string_view symbols = "0123456789ABCDEF";
    for (const std::uint8_t byte : bytes.first(std::min(bytes.size(), text_.size() / 2))) {
      text_[size_++] = symbols[byte >> 4];
      text_[size_++] = symbols[byte & 0xF];
    }
  }
  std::string_view view() const { return {text_.data(), size_}; }

 private:
  std::array<char, 128> text_{};
  std::size_t size_ = 0;
};

/// Writes text into a caller's buffer. If the text does not fit, size() is 0: half a line is never
/// sent.
class TextWriter {
 public:
  explicit TextWriter(std::span<std::uint8_t> out) : out_(out) {}

  void put(char c) {
    if (size_ < out_.size()) out_[size_] = static_cast<std::uint8_t>(c);
    ++size_;
  }

  void put(std::string_view text) {
    for (const char c : text) put(c);
  }

  /// Upper case, padded with zeros to `digits`.
  void put_hex(std::uint32_t value, unsigned digits) {
    constexpr std::string_view symbols = "0123456789ABCDEF";
    while (digits-- > 0) put(symbols[value >> 4 * digits & 0xF]);
  }

  void put_hex_bytes(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) put_hex(byte, 2);
  }

  /// Padded with zeros to `width`.
  void put_decimal(std::uint64_t value, std::size_t width) {
    std::array<char, 20> digits;
    const auto end = std::to_chars(digits.begin(), digits.end(), value).ptr;
    const auto length = static_cast<std::size_t>(end - digits.begin());
    for (std::size_t i = length; i < width; ++i) put('0');
    put(std::string_view{digits.data(), length});
  }

  std::size_t size() const { return size_ <= out_.size() ? size_ : 0; }

 private:
  std::span<std::uint8_t> out_;
  std::size_t size_ = 0;
};

}  // namespace drydock::wire
