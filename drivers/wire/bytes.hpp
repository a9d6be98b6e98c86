#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>

/// Numbers in byte sequences. Callers must check the length first.
namespace drydock::wire {

template <class T>
concept WireNumber = std::integral<T> || std::floating_point<T>;

template <WireNumber T>
T swap_bytes(T value) {
  std::uint8_t raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

/// Little-endian number at `offset`.
template <WireNumber T>
T load_le(std::span<const std::uint8_t> bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return std::endian::native == std::endian::little ? value : swap_bytes(value);
}

template <WireNumber T>
T load_be(std::span<const std::uint8_t> bytes, std::size_t offset) {
  return swap_bytes(load_le<T>(bytes, offset));
}

template <WireNumber T>
void store_le(std::span<std::uint8_t> bytes, std::size_t offset, std::type_identity_t<T> value) {
  const T ordered = std::endian::native == std::endian::little ? value : swap_bytes<T>(value);
  std::memcpy(bytes.data() + offset, &ordered, sizeof(T));
}

template <WireNumber T>
void store_be(std::span<std::uint8_t> bytes, std::size_t offset, std::type_identity_t<T> value) {
  store_le<T>(bytes, offset, swap_bytes<T>(value));
}

}  // namespace drydock::wire
