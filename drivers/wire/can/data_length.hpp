#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace drydock::wire {

/// Bytes of data by the four bits of a CAN FD frame's data length code (ISO 11898-1).
constexpr std::array<std::uint8_t, 16> fd_sizes{0, 1,  2,  3,  4,  5,  6,  7,
                                                8, 12, 16, 20, 24, 32, 48, 64};

constexpr bool is_fd_size(std::size_t size) {
  return std::find(fd_sizes.begin(), fd_sizes.end(), size) != fd_sizes.end();
}

}  // namespace drydock::wire
