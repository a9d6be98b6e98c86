#pragma once

#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <cstdlib>

namespace bench {

/// A raw pty whose two ends stay open.
struct Pty {
  int master = -1, slave = -1;
  char name[64]{};
  Pty() {
    termios raw{};
    cfmakeraw(&raw);
    if (openpty(&master, &slave, name, &raw, nullptr) != 0) std::abort();
  }
  ~Pty() {
    close(master);
    close(slave);
  }
  Pty(const Pty&) = delete;
  Pty& operator=(const Pty&) = delete;
};

}  // namespace bench
