#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <type_traits>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/quantize.hpp"
#include "drivers/wire/ubx/ubx_frame.hpp"

/// Writes the common field types of UBX payloads; ubx_payload.hpp reads them.
namespace drydock::wire::ubx {

using PayloadOut = std::span<std::uint8_t>;

template <class T>
void put(PayloadOut payload, std::size_t offset, const std::optional<double>& value, double unit,
         std::type_identity_t<T> absent = 0) {
  store_le<T>(payload, offset, value ? quantize<T>(*value, unit) : absent);
}

/// FFFFFFFF: the receiver has no estimate.
inline void put_accuracy(PayloadOut payload, std::size_t offset, const std::optional<double>& value,
                         double unit) {
  put<std::uint32_t>(payload, offset, value, unit, 0xFFFFFFFF);
}

/// 99.99: no value.
inline void put_dop(PayloadOut payload, std::size_t offset, const std::optional<double>& value) {
  constexpr std::uint16_t no_dop = 9999;
  put<std::uint16_t>(payload, offset, value, 0.01, no_dop);
}

constexpr unsigned flag(bool set, unsigned number) { return unsigned{set} << number; }

/// The payload part of a frame in `out`, filled with zeros. Empty if it does not fit.
inline PayloadOut payload_in(std::span<std::uint8_t> out, std::size_t size) {
  if (out.size() < size + overhead) return {};
  const PayloadOut payload = out.subspan(header_size, size);
  std::ranges::fill(payload, std::uint8_t{0});
  return payload;
}

/// A frame with this payload. 0: `out` is too small.
inline std::size_t encode_frame(std::uint16_t class_and_id, Bytes content,
                                std::span<std::uint8_t> out) {
  if (out.size() < content.size() + overhead) return 0;
  std::ranges::copy(content, out.begin() + header_size);
  return wrap(out, class_and_id, content.size());
}

}  // namespace drydock::wire::ubx
