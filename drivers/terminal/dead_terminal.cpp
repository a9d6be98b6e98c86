#include "drivers/terminal/dead_terminal.hpp"

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>

namespace drydock::terminal {

namespace {

bool is_dead(int output) {
  termios settings{};
  if (::tcgetattr(output, &settings) != 0 && errno == EIO) return true;
  pollfd pipe{output, 0, 0};
  return ::poll(&pipe, 1, 0) == 1 && (pipe.revents & POLLERR) != 0;
}

}  // namespace

void leave_dead_terminal() {
  const int error = errno;
  for (const int output : {STDOUT_FILENO, STDERR_FILENO}) {
    if (!is_dead(output)) continue;
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nowhere, output);
    ::close(nowhere);
  }
  errno = error;
}

void forget_unread_lines() {
  std::fflush(stdout);
  std::clearerr(stdout);
}

void hold_lines_of_pipe() {
  static std::array<char, 1 << 20> held;
  if (::isatty(STDOUT_FILENO) == 0) std::setvbuf(stdout, held.data(), _IOFBF, held.size());
}

}  // namespace drydock::terminal
