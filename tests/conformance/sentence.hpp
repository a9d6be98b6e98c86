#pragma once

#include <span>
#include <string>
#include <vector>

#include "tests/conformance/reading.hpp"
#include "tests/conformance/score.hpp"

/// Single sentences as vectors: the values are the text itself, by the column that the document
/// gives them.
namespace drydock::conformance {

/// One value of a sentence. Column 0 is the address. ours = text * scale + offset; `none` is the
/// number that stands for no value; a resolution is that of the text's last digit.
struct Slot {
  const char* key;
  int element = -1;  ///< of an array, else -1
  std::size_t column = 0;
  double scale = 1, offset = 0;
  const char* none = "";
  bool when_valid = false;  ///< empty unless the sentence says that it is valid
};

struct Layout {
  std::string_view address;
  std::span<const Slot> slots;
  std::size_t valid_column = 0;  ///< 0: it does not say
  std::string_view valid = {};
};

/// The text between `$` and `*`, split at commas, NAME= taken off.
std::vector<std::string> fields_of(std::string_view sentence);

void compare(const json& ours, const std::vector<std::string>& theirs, const Layout& layout,
             Comparison& c);

/// A sentence whose checksum is right: with a layout it must give one message with these values,
/// without one none.
void compare_sound(std::string_view protocol, const std::string& file, std::size_t line,
                   const std::string& sentence, const Layout* layout, Score& score);

/// A sentence whose checksum is wrong must be refused.
void compare_damaged(std::string_view protocol, const std::string& file, std::size_t line,
                     const std::string& sentence, Score& score);

const Layout* find(std::span<const Layout> layouts, std::string_view address);

}  // namespace drydock::conformance
