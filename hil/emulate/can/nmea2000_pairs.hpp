#pragma once

#include <cstdint>
#include <vector>

#include "drivers/wire/codec.hpp"

namespace drydock::emulate {

/// A field of a PGN as a group function speaks of it: its number and its value in whole bytes.
struct Nmea2000Field {
  static constexpr std::uint8_t text = 0;  ///< a length of its own, with the two bytes before it
  std::uint8_t number = 0;
  std::uint8_t bytes = 1;
  std::vector<std::uint8_t> value;  ///< that it has now
};

/// One pair of a field and a value.
struct Nmea2000Pair {
  std::uint8_t number = 0;
  wire::Bytes value;
  std::uint8_t code = 0;  ///< of its answer
};

struct Nmea2000Pairs {
  std::vector<Nmea2000Pair> all;
  bool cut_short = false;  ///< the message ends before its last pair
};

/// Takes the pairs of a message apart. After a field that the PGN does not have, nothing tells how
/// long a value is: the pair is invalid, those after it cannot be obeyed now.
Nmea2000Pairs pairs_in(wire::Bytes bytes, std::size_t count,
                       const std::vector<Nmea2000Field>& fields);

/// Gives each pair whose value is not that of its field the code "out of range".
void compare(Nmea2000Pairs& pairs, const std::vector<Nmea2000Field>& fields);

}  // namespace drydock::emulate
