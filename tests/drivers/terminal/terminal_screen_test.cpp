#include "drivers/terminal/terminal_screen.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>

namespace terminal_screen_test {

using drydock::terminal::erases_lines;
using drydock::terminal::screen_size;

/// A terminal that nobody looks at.
class Terminal {
 public:
  Terminal() : master_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    ::grantpt(master_);
    ::unlockpt(master_);
    screen = ::open(::ptsname(master_), O_RDWR | O_NOCTTY);
  }
  ~Terminal() {
    ::close(screen);
    ::close(master_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  int screen = -1;

 private:
  int master_;
};

TEST(TerminalScreen, HasTheSizeThatTheTerminalTells) {
  const Terminal terminal;
  const winsize size{.ws_row = 15, .ws_col = 60, .ws_xpixel = 0, .ws_ypixel = 0};
  ASSERT_EQ(::ioctl(terminal.screen, TIOCSWINSZ, &size), 0);
  EXPECT_EQ(screen_size(terminal.screen).columns, 60U);
  EXPECT_EQ(screen_size(terminal.screen).rows, 15U);
}

TEST(TerminalScreen, Is80By24WhereNobodyTellsASize) {
  const Terminal silent;  // a new one tells 0 by 0
  EXPECT_EQ(screen_size(silent.screen).columns, 80U);
  EXPECT_EQ(screen_size(-1).rows, 24U);
}

TEST(TerminalScreen, ErasesItsLinesUnlessItIsDumb) {
  const Terminal terminal;
  ::setenv("TERM", "xterm", 1);
  EXPECT_TRUE(erases_lines(terminal.screen));
  EXPECT_FALSE(erases_lines(-1));
  ::setenv("TERM", "dumb", 1);
  EXPECT_FALSE(erases_lines(terminal.screen));
  ::unsetenv("TERM");
  EXPECT_FALSE(erases_lines(terminal.screen));
}

}  // namespace terminal_screen_test
