#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <span>
#include <string_view>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/crc.hpp"

/// What follows from a message's fields, which `M::lay_out(message, visitor)` shows in the order of
/// the wire: the largest numbers first, extensions last. The visitors here give the seed of the
/// checksum and the payload's size, write it and read it. Source: MAVLink developer guide, packet
/// serialization.
namespace drydock::wire::mavlink {

/// A type of the definition: its name, and the number on the wire.
template <class T>
struct WireType;
template <>
struct WireType<std::uint8_t> {
  using Number = std::uint8_t;
  static constexpr std::string_view name = "uint8_t";
};
template <>
struct WireType<std::int8_t> {
  using Number = std::int8_t;
  static constexpr std::string_view name = "int8_t";
};
template <>
struct WireType<char> {
  using Number = std::uint8_t;
  static constexpr std::string_view name = "char";
};
template <>
struct WireType<std::uint16_t> {
  using Number = std::uint16_t;
  static constexpr std::string_view name = "uint16_t";
};
template <>
struct WireType<std::int16_t> {
  using Number = std::int16_t;
  static constexpr std::string_view name = "int16_t";
};
template <>
struct WireType<std::int32_t> {
  using Number = std::int32_t;
  static constexpr std::string_view name = "int32_t";
};
template <>
struct WireType<std::uint32_t> {
  using Number = std::uint32_t;
  static constexpr std::string_view name = "uint32_t";
};
template <>
struct WireType<float> {
  using Number = float;
  static constexpr std::string_view name = "float";
};
template <>
struct WireType<std::chrono::milliseconds> {
  using Number = std::uint32_t;
  static constexpr std::string_view name = "uint32_t";
};
template <>
struct WireType<std::chrono::microseconds> {
  using Number = std::uint64_t;
  static constexpr std::string_view name = "uint64_t";
};
template <>
struct WireType<std::chrono::nanoseconds> {
  using Number = std::int64_t;
  static constexpr std::string_view name = "int64_t";
};

/// CRC-16/MCRF4XX.
inline constexpr Crc checksum({16, 0x1021, 0xFFFF, true, 0});

/// The byte that ends the checksum of each message of one kind, so that both ends must agree on its
/// fields. Extensions do not count.
class CrcExtra {
 public:
  constexpr explicit CrcExtra(std::string_view message) { add(message); }

  template <class T>
  constexpr void operator()(std::string_view name, const T&) {
    add(WireType<T>::name);
    add(name);
  }
  template <class T, std::size_t N>
  constexpr void operator()(std::string_view name, const std::array<T, N>& values) {
    (*this)(name, values[0]);
    add_byte(N);
  }
  template <class T>
  constexpr void extension(std::string_view, const T&) {}

  constexpr std::uint8_t value() const {
    return static_cast<std::uint8_t>((state_ & 0xFF) ^ (state_ >> 8));
  }

 private:
  constexpr void add(std::string_view word) {
    for (const char letter : word) add_byte(static_cast<std::uint8_t>(letter));
    add_byte(' ');
  }
  constexpr void add_byte(std::uint8_t byte) { state_ = checksum.add(state_, {&byte, 1}); }

  std::uint64_t state_ = checksum.start();
};

/// Puts the fields behind each other, little-endian. `payload` must have room for all of them.
class PayloadWriter {
 public:
  explicit PayloadWriter(std::span<std::uint8_t> payload) : payload_(payload) {}

  template <class T>
  void operator()(std::string_view, const T& value) {
    using Number = typename WireType<T>::Number;
    if constexpr (requires { value.count(); }) {
      store_le<Number>(payload_, at_, static_cast<Number>(value.count()));
    } else {
      store_le<Number>(payload_, at_, static_cast<Number>(value));
    }
    at_ += sizeof(Number);
  }
  template <class T, std::size_t N>
  void operator()(std::string_view name, const std::array<T, N>& values) {
    for (const T& value : values) (*this)(name, value);
  }
  template <class T>
  void extension(std::string_view name, const T& value) {
    (*this)(name, value);
  }
  std::size_t size() const { return at_; }

 private:
  std::span<std::uint8_t> payload_;
  std::size_t at_ = 0;
};

/// The reverse. `payload` has all fields: those that were cut off are zero.
class PayloadReader {
 public:
  explicit PayloadReader(std::span<const std::uint8_t> payload) : payload_(payload) {}

  template <class T>
  void operator()(std::string_view, T& value) {
    using Number = typename WireType<T>::Number;
    const auto number = load_le<Number>(payload_, at_);
    if constexpr (requires { value.count(); }) {
      value = T{static_cast<typename T::rep>(number)};
    } else {
      value = static_cast<T>(number);
    }
    at_ += sizeof(Number);
  }
  template <class T, std::size_t N>
  void operator()(std::string_view name, std::array<T, N>& values) {
    for (T& value : values) (*this)(name, value);
  }
  template <class T>
  void extension(std::string_view name, T& value) {
    (*this)(name, value);
  }

 private:
  std::span<const std::uint8_t> payload_;
  std::size_t at_ = 0;
};

/// CRC_EXTRA of a kind of message.
template <class M>
constexpr std::uint8_t crc_extra_of() {
  CrcExtra seed(M::type);
  const M message{};
  M::lay_out(message, seed);
  return seed.value();
}

}  // namespace drydock::wire::mavlink
