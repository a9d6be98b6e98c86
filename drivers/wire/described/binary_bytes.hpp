#pragma once

#include "drivers/wire/described/plan.hpp"
#include "drivers/wire/text_bytes.hpp"

/// How the bytes of a binary message are read and written.
namespace drydock::wire::described {

inline std::uint64_t load(Bytes bytes, std::size_t at, std::size_t size, bool big_endian) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i)
    value = value << 8 | bytes[at + (big_endian ? i : size - 1 - i)];
  return value;
}

inline void store(std::span<std::uint8_t> out, std::size_t at, std::size_t size, bool big_endian,
                  std::uint64_t value) {
  for (std::size_t i = 0; i < size; ++i, value >>= 8)
    out[at + (big_endian ? size - 1 - i : i)] = static_cast<std::uint8_t>(value);
}

/// Turns the order of the 16-bit words of an integer of `size` bytes, which is even.
constexpr std::uint64_t words_turned(std::uint64_t value, std::size_t size) {
  std::uint64_t turned = 0;
  for (std::size_t i = 0; i < size; i += 2, value >>= 16) turned = turned << 16 | (value & 0xFFFF);
  return turned;
}

/// The bits of a field of this message, the lowest one as bit 0.
inline std::uint64_t load(const Field& field, Bytes bytes) {
  const std::uint64_t raw = load(bytes, field.at, field.size, field.big_endian);
  return field.low_word_first ? words_turned(raw, field.size) : raw;
}

inline void store(const Field& field, std::uint64_t value, std::span<std::uint8_t> out) {
  store(out, field.at, field.size, field.big_endian,
        field.low_word_first ? words_turned(value, field.size) : value);
}

constexpr std::uint64_t mask_of(unsigned bits) {
  return bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
}

inline unsigned bits_of(const Field& field) {
  return field.bits != 0 ? field.bits : 8u * field.size;
}

inline bool has_constant(const Field& field, Bytes bytes) {
  return static_cast<double>(load(field, bytes) >> field.first_bit & mask_of(bits_of(field))) ==
         field.idle;
}

/// Bytes of a whole message that begins so. Empty: more bytes must come before that is known.
inline std::optional<std::size_t> length_of(const Length& length, Bytes bytes) {
  if (length.size == 0) return length.fixed;
  if (bytes.size() < length.at + std::size_t{length.size}) return {};
  return load(bytes, length.at, length.size, length.big_endian) + length.plus;
}

/// True if a whole message of so many bytes has the length that it should have.
inline bool has_length(const Length& length, Bytes whole) {
  const auto told = length_of(length, whole);
  return length.is_any() || (told && *told == whole.size());
}

}  // namespace drydock::wire::described
