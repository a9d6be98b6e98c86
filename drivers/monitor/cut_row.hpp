#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace drydock::monitor {

/// The first `width` columns of a line of UTF-8. Escape sequences take no column and are all kept,
/// so that a colour which began ends too.
std::string cut_row(std::string_view line, std::size_t width);

}  // namespace drydock::monitor
