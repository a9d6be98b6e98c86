#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace drydock::guess {

/// The digits of each column of hexadecimal texts that are equally long. In a number the last digit
/// changes most often and the first most seldom, so a column begins where a digit changes much more
/// seldom than the one before it.
std::vector<std::size_t> hex_columns(const std::vector<std::string_view>& texts);

}  // namespace drydock::guess
