#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace drydock::wire {

struct PgnRange {
  std::uint32_t first, last;
};

template <std::size_t count>
constexpr bool is_in(const std::array<PgnRange, count>& ranges, std::uint32_t pgn) {
  return std::any_of(ranges.begin(), ranges.end(), [&](const PgnRange& range) {
    return range.first <= pgn && pgn <= range.last;
  });
}

/// The PGNs of NMEA 2000 that travel as fast packets, from canboat's database: in these ranges it
/// knows no PGN that travels otherwise. Those of manufacturers beyond 130815 are left out.
constexpr std::array<PgnRange, 21> fast_pgns{
    {{126208, 126988}, {126996, 127237}, {127489, 127491}, {127494, 127498}, {127503, 127504},
     {127506, 127507}, {127509, 127514}, {128275, 128538}, {129029, 129029}, {129038, 129045},
     {129284, 129285}, {129301, 129538}, {129540, 129545}, {129547, 129549}, {129551, 130074},
     {130320, 130330}, {130561, 130574}, {130577, 130578}, {130580, 130581}, {130583, 130584},
     {130586, 130586}}};

/// The PGNs of NMEA 2000 that are one frame, from the same database in the same way.
constexpr std::array<PgnRange, 20> single_pgns{
    {{126992, 126993}, {127245, 127488}, {127493, 127493}, {127500, 127502}, {127505, 127505},
     {127508, 127508}, {127744, 128267}, {128768, 129028}, {129033, 129033}, {129283, 129283},
     {129291, 129291}, {129539, 129539}, {129546, 129546}, {129550, 129550}, {130306, 130316},
     {130560, 130560}, {130576, 130576}, {130579, 130579}, {130582, 130582}, {130585, 130585}}};

/// Those below are J1939's: its transport protocol carries what one frame cannot.
constexpr std::uint32_t first_pgn_of_nmea2000 = 126208;

constexpr bool is_fast_pgn(std::uint32_t pgn) { return is_in(fast_pgns, pgn); }
constexpr bool is_single_pgn(std::uint32_t pgn) { return is_in(single_pgns, pgn); }

}  // namespace drydock::wire
