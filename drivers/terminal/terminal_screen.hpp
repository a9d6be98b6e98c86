#pragma once

#include <cstddef>

/// What a terminal behind a file descriptor can show.
namespace drydock::terminal {

/// True for a terminal that erases and overwrites its lines; false on TERM=dumb and elsewhere.
bool erases_lines(int descriptor);

struct ScreenSize {
  std::size_t columns = 80, rows = 24;  ///< as given here where the terminal does not tell
};
ScreenSize screen_size(int descriptor);

}  // namespace drydock::terminal
