#include "drivers/terminal/dead_terminal.hpp"

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>

namespace drydock::terminal {

void leave_dead_terminal() {
  const int error = errno;
  for (const int output : {STDOUT_FILENO, STDERR_FILENO}) {
    termios settings{};
    if (::tcgetattr(output, &settings) == 0 || errno != EIO) continue;
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nowhere, output);
    ::close(nowhere);
  }
  errno = error;
}

}  // namespace drydock::terminal
