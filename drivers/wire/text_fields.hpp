#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/codec.hpp"

/// Fields of a line of text, separated by one character. For protocols other than NMEA 0183.
namespace drydock::wire {

/// Reads fields from left to right. A field that is empty, missing or malformed reads as empty and
/// never affects the others. Blanks around a field and a leading plus are ignored.
class TextFields {
 public:
  explicit TextFields(std::string_view text, char separator = ',')
      : rest_(text), separator_(separator) {}

  std::size_t remaining() const;  ///< fields not yet read
  std::string_view text();
  std::optional<double> number();  ///< finite; with or without exponent
  std::optional<int> integer();
  std::optional<double> angle();  ///< degrees on the wire, rad here

 private:
  std::string_view rest_;
  char separator_;
  bool ended_ = false;
};

std::optional<double> parse_number(std::string_view text);
std::optional<int> parse_integer(std::string_view text);

/// Writes text and fields into a buffer.
class FieldWriter {
 public:
  explicit FieldWriter(std::span<std::uint8_t> out) : out_(out) {}

  void text(std::string_view text) {
    if (overflow_ || text.size() > out_.size() - size_) {
      overflow_ = true;
      return;
    }
    if (!text.empty()) std::memcpy(out_.data() + size_, text.data(), text.size());
    size_ += text.size();
  }
  void number(double value, int decimals);  ///< only the digits, without a separator
  Bytes written() const { return {out_.data(), size()}; }
  std::size_t size() const { return overflow_ ? 0 : size_; }  ///< 0: the buffer was too small

 private:
  std::span<std::uint8_t> out_;
  std::size_t size_ = 0;
  bool overflow_ = false;
};

inline std::string_view as_text(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace drydock::wire
