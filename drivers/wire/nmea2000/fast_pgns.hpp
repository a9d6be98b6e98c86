#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace drydock::wire {

struct PgnRange {
  std::uint32_t first, last;
};

/// The PGNs of NMEA 2000 that travel as fast packets, from canboat's database: in these ranges it
/// knows no PGN that travels otherwise. Those of manufacturers beyond 130815 are left out.
constexpr std::array<PgnRange, 21> fast_pgns{
    {{126208, 126988}, {126996, 127237}, {127489, 127491}, {127494, 127498}, {127503, 127504},
     {127506, 127507}, {127509, 127514}, {128275, 128538}, {129029, 129029}, {129038, 129045},
     {129284, 129285}, {129301, 129538}, {129540, 129545}, {129547, 129549}, {129551, 130074},
     {130320, 130330}, {130561, 130574}, {130577, 130578}, {130580, 130581}, {130583, 130584},
     {130586, 130586}}};

constexpr bool is_fast_pgn(std::uint32_t pgn) {
  return std::any_of(fast_pgns.begin(), fast_pgns.end(), [&](const PgnRange& range) {
    return range.first <= pgn && pgn <= range.last;
  });
}

}  // namespace drydock::wire
