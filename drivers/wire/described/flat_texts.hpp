#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "drivers/wire/codec.hpp"

/// What decoding a text looks at, in the order in which it does.
namespace drydock::wire::described {

struct Plan;

/// A message by its fields in order. Numbers are places of fields.
struct FlatText {
  std::uint16_t message = 0;  ///< in Plan::messages
  std::uint16_t first_field = 0;
  std::uint8_t fields = 0, fewest = 0;  ///< fewest: that must be there
  std::vector<std::uint8_t> constants;
  std::vector<std::uint8_t> read;   ///< numbers and texts
  std::vector<std::uint8_t> blank;  ///< shown, but never with a value
};

/// Messages in a row that begin alike and are cut into fields alike.
struct FlatFamily {
  std::string head;
  bool any_talker = false;
  std::uint64_t word = 0, mask = 0;  ///< of the first eight bytes, the first one lowest
  /// It stands behind every field but the last, which runs to the end. 0: the ends differ.
  char separator = 0;
  bool by_pattern = false;
  std::uint16_t first = 0, count = 0;  ///< in FlatTexts::texts
};

struct FlatTexts {
  FlatTexts() = default;
  explicit FlatTexts(const Plan& plan);

  std::vector<FlatText> texts;
  std::vector<FlatFamily> families;
  /// Characters of a sentence at which a scan must look closer: `*`, line ends, what cannot be
  /// printed, and those with which a message can begin.
  std::array<bool, 256> stops{};
};

/// True if a message of this family can begin so.
bool begins(const FlatFamily& family, Bytes bytes);

}  // namespace drydock::wire::described
