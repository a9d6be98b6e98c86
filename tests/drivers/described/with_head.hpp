#pragma once

#include "tests/drivers/described/support.hpp"

namespace drydock::described::test {

/// The beginning of a description of a depth sensor.
constexpr std::string_view head =
    "[sensor]\ntitle = \"t\"\nkind = \"depth\"\n[protocol]\n";  // lines 1 to 4

/// The problems of that description with more.
inline std::string with(std::string_view more) {
  return problems_of(std::string(head) + std::string(more));
}

}  // namespace drydock::described::test
