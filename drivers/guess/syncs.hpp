#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "drivers/wire/codec.hpp"

namespace drydock::guess {

constexpr std::size_t shortest_synced_frame = 6, fewest_synced_frames = 4;

/// One byte or two with which frames may begin, and every place at which they stand.
struct Sync {
  std::array<std::uint8_t, 2> bytes{};
  std::size_t size = 2;
  std::vector<std::uint32_t> places;

  bool stands(wire::Bytes capture, std::size_t at) const {
    return at + size <= capture.size() && capture[at] == bytes[0] &&
           (size == 1 || capture[at + 1] == bytes[1]);
  }
};

/// Those that stand often enough, and not so often that frames would be too short.
std::vector<Sync> syncs_of(wire::Bytes capture);

}  // namespace drydock::guess
