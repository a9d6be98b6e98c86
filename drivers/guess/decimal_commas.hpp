#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drydock::guess {

/// True if the numbers of these lines have their fraction behind a comma: every comma is between
/// digits, no number has two of them, no number has a point, and what is between numbers is
/// another character.
bool have_decimal_commas(const std::vector<std::string_view>& lines);

/// The line with points.
std::string with_points(std::string_view line);

}  // namespace drydock::guess
