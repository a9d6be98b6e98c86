#include "drivers/terminal/terminal_width.hpp"

#include <sys/ioctl.h>

namespace drydock::terminal {

std::size_t width_of_terminal(int descriptor) {
  constexpr std::size_t usual = 80;
  winsize size{};
  const bool known = ::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : usual;
}

}  // namespace drydock::terminal
