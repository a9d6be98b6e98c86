#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "drivers/wire/codec.hpp"

namespace drydock::wire::pgn_table {

/// `count` bits from 1 to 64, the lowest first, as a number; empty if the message ends before.
constexpr std::optional<std::uint64_t> bits_at(Bytes message, std::size_t offset,
                                               std::size_t count) {
  if (offset + count > 8 * message.size()) return {};
  std::uint64_t value = 0;
  for (std::size_t got = 0; got < count;) {
    const std::size_t bit = (offset + got) % 8;
    const std::size_t taken = std::min(8 - bit, count - got);
    const std::uint64_t part = (message[(offset + got) / 8] >> bit) & ((1U << taken) - 1);
    value |= part << got;
    got += taken;
  }
  return value;
}

/// The highest number of `count` bits.
constexpr std::uint64_t highest(std::size_t count, bool is_signed) {
  const std::size_t digits = is_signed ? count - 1 : count;
  return digits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << digits) - 1;
}

constexpr std::int64_t with_sign(std::uint64_t raw, std::size_t count) {
  const std::size_t unused = 64 - count;
  return static_cast<std::int64_t>(raw << unused) >> unused;
}

}  // namespace drydock::wire::pgn_table
