#pragma once

#include <cstddef>

namespace drydock::terminal {

/// Columns of the terminal of a file descriptor; 80 where it has none to tell.
std::size_t width_of_terminal(int descriptor);

}  // namespace drydock::terminal
