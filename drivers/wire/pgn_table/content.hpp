#pragma once

#include <limits>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/pgn_table/record.hpp"

namespace drydock::wire::pgn_table {

inline constexpr std::size_t all_left = std::numeric_limits<std::size_t>::max();

/// Bits of a message: the bytes from the one with the first bit on.
struct Slice {
  Bytes bytes;
  std::size_t first_bit = 0;  ///< in the first byte
  std::size_t bits = 0;       ///< that may be read
};

/// What was read, and how many bits that took.
struct Extent {
  Value value;
  std::optional<std::uint64_t> raw;  ///< of a number that the message has
  std::size_t bits = 0;
};

/// Reads a field. `other` is the raw number on which an indirect lookup depends.
Extent read(const Table& table, const Field& field, const Slice& slice,
            std::optional<std::uint64_t> other);

/// Whole bytes as hexadecimal text.
Extent read_bytes(const Slice& slice);

}  // namespace drydock::wire::pgn_table
