#pragma once

#include <span>
#include <string>
#include <vector>

#include "tests/conformance/reading.hpp"
#include "tests/conformance/score.hpp"

/// Single sentences as vectors. The values come from the text itself, by the columns in the
/// document.
namespace drydock::conformance {

/// One value of a sentence. Column 0 is the address. ours = text * scale + offset. `none` is the
/// number that means no value. The resolution is that of the text's last digit.
struct Slot {
  const char* key;
  int element = -1;  ///< index in an array, otherwise -1
  std::size_t column = 0;
  double scale = 1, offset = 0;
  const char* none = "";
  bool when_valid = false;  ///< empty unless the sentence marks it as valid
};

struct Layout {
  std::string_view address;
  std::span<const Slot> slots;
  std::size_t valid_column = 0;  ///< 0: it has no such mark
  std::string_view valid = {};
};

/// The text between `$` and `*`, split at commas, without NAME=.
std::vector<std::string> fields_of(std::string_view sentence);

void compare(const json& ours, const std::vector<std::string>& theirs, const Layout& layout,
             Comparison& c);

/// A sentence with a right checksum. With a layout it must give one message with these values,
/// without a layout none.
void compare_sound(std::string_view protocol, const std::string& file, std::size_t line,
                   const std::string& sentence, const Layout* layout, Score& score);

/// A sentence with a wrong checksum must be refused.
void compare_damaged(std::string_view protocol, const std::string& file, std::size_t line,
                     const std::string& sentence, Score& score);

const Layout* find(std::span<const Layout> layouts, std::string_view address);

}  // namespace drydock::conformance
