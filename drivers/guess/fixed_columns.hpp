#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drydock::guess {

/// What stands at some places of every line.
struct FixedColumn {
  enum class Holds : std::uint8_t { constant, number, hexadecimal, text };
  Holds holds = Holds::constant;
  std::size_t at = 0, size = 0;
};

/// The columns of lines that are equally long, in order and without gaps. Empty: some places hold
/// words or anything, so that the lines have no columns.
std::vector<FixedColumn> fixed_columns(const std::vector<std::string_view>& lines);

/// The description of lines that are equally long. Empty: they have no columns with numbers.
std::optional<std::string> fixed_lines_text(const std::vector<std::string_view>& lines);

}  // namespace drydock::guess
